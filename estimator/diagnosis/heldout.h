// Errors on data that no fit has seen, per path, as the contract defines them.
#pragma once

#include "estimator/diagnosis/bench.h"
#include "estimator/diagnosis/diagnosis.h"

namespace searig::estimator {

/// Residuals at the load cell's samples; NaN where there is nothing to compare.
struct PathResiduals {
  Eigen::VectorXd spring, drive;
};

/// Every block of about ten seconds is predicted by a fit of the amplitudes to all the others.
PathResiduals heldout_residuals(const Bench& bench, const Hypothesis& hypothesis);

/// The same with amplitudes that are given instead of fitted (one vector per piece), no nuisance.
PathResiduals given_residuals(const Bench& bench, const Hypothesis& hypothesis,
                              const std::vector<Eigen::VectorXd>& amplitudes);

/// Over the entries that are not NaN; negative where there is none.
double rms_of(const Eigen::VectorXd& residual);

}  // namespace searig::estimator
