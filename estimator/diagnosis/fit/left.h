// What a hypothesis leaves of one of the two blocks of rows.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

struct Left {
  Eigen::VectorXd residual;  ///< N*m, before whitening
  std::vector<bool> usable;

  /// Sum of squares over the usable rows.
  double power() const;
  /// Over the usable rows; 0 where there is none.
  double rms() const;
  /// -2 log likelihood under the noise that makes it likeliest, up to constants.
  double badness() const;
};

/// Of the load cell's rows of a residual (Bench::raw_residual), or of the drive's.
Left left_of(const Bench& bench, const Eigen::VectorXd& residual, bool drive);

}  // namespace searig::estimator
