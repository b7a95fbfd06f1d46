#include "estimator/evaluation/score.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace searig::estimator {

namespace {
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double rounding2 = 1e-24;  // a relative spread of 1e-12 is rounding
}  // namespace

Score score(std::span<const double> estimate_nm, std::span<const double> measured_nm) {
  double error = 0, square = 0, size = 0;
  std::size_t n = 0;
  for (std::size_t i = 0; i < measured_nm.size(); ++i) {
    const double difference = estimate_nm[i] - measured_nm[i];
    if (!std::isfinite(difference)) continue;
    error += std::abs(difference);
    square += difference * difference;
    size += std::abs(measured_nm[i]);
    ++n;
  }
  if (n == 0) return {nothing, nothing};
  return {size > 0 ? 100 * error / size : nothing, std::sqrt(square / static_cast<double>(n))};
}

// slope = sum w (x - mx)(y - my) / sum w (x - mx)^2, the means taken first so that a large common
// part of x or y costs no digits.
Line fit_line(std::span<const double> x, std::span<const double> y,
              std::span<const double> weights) {
  const auto weight = [&](std::size_t i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) return 0.0;
    return weights.empty() ? 1.0 : weights[i];
  };
  double sum = 0, mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double w = weight(i);
    if (w == 0) continue;
    sum += w, mean_x += w * x[i], mean_y += w * y[i];
  }
  mean_x /= sum, mean_y /= sum;
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double w = weight(i);
    if (w == 0) continue;
    xx += w * (x[i] - mean_x) * (x[i] - mean_x);
    xy += w * (x[i] - mean_x) * (y[i] - mean_y);
  }
  const bool varies = xx > sum * mean_x * mean_x * rounding2;
  const double slope = varies ? xy / xx : nothing;
  return {slope, mean_y - slope * mean_x};
}

}  // namespace searig::estimator
