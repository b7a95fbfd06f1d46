// From an account to what is asserted, what is withdrawn, and what stays open.
#pragma once

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/diagnosis/fit/heldout.h"
#include "estimator/diagnosis/search/account.h"

namespace searig::estimator {

struct Stated {
  double zero_nm = 0.0;  ///< the load cell's, where it is one
  Hypothesis asserted;   ///< the final one without what has no name and what was taken back
};

/// Fills findings, unexplained, undecidable, numbers and the extended model. `after` is what the
/// final hypothesis leaves on held-out blocks; `out` has its path errors already.
Stated state_findings(const Bench& bench, const Account& account, const PathResiduals& after,
                      const Model& given, std::size_t atoms, Diagnosis& out);

}  // namespace searig::estimator
