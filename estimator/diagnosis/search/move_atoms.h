// The places of an account's atoms, once it is known which atoms they are.
#pragma once

#include "estimator/diagnosis/search/account.h"

namespace searig::estimator {

/// Atoms come from a coarse grid of places; what they tell is where. Two changes of one kind, there
/// and back, become one that lasts for a while. The score of `final` is left as it was.
void move_atoms(const Bench& bench, Account& account);

}  // namespace searig::estimator
