// Order statistics that several steps share.
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

}  // namespace searig::estimator
