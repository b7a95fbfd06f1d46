// Rates and accelerations from sampled angles, by local least squares on the actual sample times.
#pragma once

#include <span>
#include <vector>

namespace searig::estimator {

struct Derivatives {
  double value = 0.0;
  double first = 0.0;   ///< per second
  double second = 0.0;  ///< per second squared
};

/// Least-squares cubic through (t, x), evaluated at time `at`: a Savitzky-Golay filter that takes
/// uneven samples (A. Savitzky, M. Golay, Anal. Chem. 36, 1964). Needs t.size() >= 5 distinct
/// times; with fewer it falls back to the straight line through the ends.
Derivatives local_cubic(std::span<const double> t, std::span<const double> x, double at);

/// The same for every sample of a channel, over the samples within +-half_width_s of it (at least
/// five). Shapes: all vectors as long as t.
struct Kinematics {
  std::vector<double> value, first, second;
};
Kinematics differentiate(std::span<const double> t, std::span<const double> x, double half_width_s);

}  // namespace searig::estimator
