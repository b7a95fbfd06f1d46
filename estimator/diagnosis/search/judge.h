// Whether what was found holds once everything is in place.
#pragma once

#include "estimator/diagnosis/search/account.h"

namespace searig::estimator {

/// Drops named pieces that do not hold, and lets rivals that fit better in their place take it,
/// until each that is left is assessed. Leaves the bench with the noise of the final hypothesis.
void judge(Bench& bench, Search& search, Account& account);

}  // namespace searig::estimator
