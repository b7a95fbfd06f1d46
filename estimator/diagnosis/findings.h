// From an account to what is asserted, what is withdrawn, and what stays open.
#pragma once

#include "estimator/diagnosis/account.h"
#include "estimator/diagnosis/diagnosis.h"

namespace searig::estimator {

/// Fills findings, unexplained, undecidable, numbers and the extended model. `out` has its path
/// errors already. Returns the load cell's zero in N*m where it is one, else 0.
double state_findings(const Bench& bench, const Account& account, const Model& given,
                      std::size_t atoms, Diagnosis& out);

}  // namespace searig::estimator
