// Errors on data that no fit has seen, per path, as the contract defines them.
#pragma once

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/diagnosis/fit/bench.h"

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

/// Of a held-out error: so much is chance.
inline constexpr double heldout_chance = 0.003;

/// Logarithm of how much larger the errors of one hypothesis are on blocks that no fit saw than
/// those of the other, all paths taken together; negative where it predicts better.
double worse_by(const Bench& bench, const Hypothesis& one, const Hypothesis& other);

/// Whether a nameless term predicts unseen blocks clearly worse than nothing does. One with a time
/// of its own may live in one block alone, where no other predicts it, and is let off.
bool misleads(const Bench& bench, const Atom& atom, const Hypothesis& with,
              const Hypothesis& without);

/// Over the entries that are not NaN; negative where there is none.
double rms_of(const Eigen::VectorXd& residual);

}  // namespace searig::estimator
