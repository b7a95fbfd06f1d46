// Order statistics that several rooms share.
#pragma once

#include <algorithm>
#include <vector>

namespace searig::estimator {

/// The middle value (the upper one of two); 0 of nothing.
inline double median(std::vector<double> x) {
  if (x.empty()) return 0.0;
  const auto middle = x.begin() + std::ptrdiff_t(x.size() / 2);
  std::ranges::nth_element(x, middle);
  return *middle;
}

/// The usual time between samples, s; 1 where there are less than two.
inline double median_step(const std::vector<double>& t) {
  if (t.size() < 2) return 1.0;
  std::vector<double> step(t.size() - 1);
  for (std::size_t i = 0; i + 1 < t.size(); ++i) step[i] = t[i + 1] - t[i];
  return median(std::move(step));
}

}  // namespace searig::estimator
