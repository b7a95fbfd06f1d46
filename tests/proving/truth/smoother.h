#pragma once

#include <vector>

namespace searig::proving {

struct Smoothed {
  std::vector<double> value, rate, acceleration;
};

/// Local cubic regression with Gaussian weights (Savitzky-Golay for uneven samples): flat to
/// fourth order, so that motion passes and only noise is taken away.
Smoothed smooth_at(const std::vector<double>& at_s, const std::vector<double>& t_s,
                   const std::vector<double>& y, double sigma_s);

}  // namespace searig::proving
