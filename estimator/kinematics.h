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

/// The samples [from, to) within +-half_width_s of a centre; where they are sparse the nearest ones
/// up to five, so that a gap is not reached across while there are neighbours on this side of it.
/// What comes after t[to] has no say in it: a stream that has seen t[to] gets the same window.
struct Window {
  std::size_t from = 0, to = 0;
};
Window window_about(std::span<const double> t, std::size_t centre, double half_width_s);

/// The cubic through the window about one sample, at it.
Derivatives derivatives_at(std::span<const double> t, std::span<const double> x, std::size_t centre,
                           double half_width_s);

/// The same for every sample of a channel. Shapes: all vectors as long as
/// t.
struct Kinematics {
  std::vector<double> value, first, second;
};
Kinematics differentiate(std::span<const double> t, std::span<const double> x, double half_width_s);

}  // namespace searig::estimator
