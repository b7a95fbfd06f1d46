// How far an estimate is from the load cell, and the lines fitted to the load cell.
#pragma once

#include <span>

namespace searig::estimator {

struct Score {
  double error_percent = 0;  ///< 100 mean |estimate - measured| / mean |measured|
  double rmse_nm = 0;        ///< root mean square of estimate - measured
};

/// Over the samples where both are finite; NaN where there are none. Both as long as each other.
Score score(std::span<const double> estimate_nm, std::span<const double> measured_nm);

/// y = slope x + offset
struct Line {
  double slope = 0;
  double offset = 0;
};

/// The least-squares line through (x, y), each sample with its weight; no weights means all alike.
/// Samples that are not finite are left out. The slope is NaN where x does not vary.
Line fit_line(std::span<const double> x, std::span<const double> y,
              std::span<const double> weights = {});

}  // namespace searig::estimator
