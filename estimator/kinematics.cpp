#include "estimator/kinematics.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace searig::estimator {

Derivatives local_cubic(std::span<const double> t, std::span<const double> x, double at) {
  const std::size_t n = t.size();
  if (n == 0) return {};
  const double scale = std::max({t.back() - at, at - t.front(), 1e-12});
  if (n < 5) {
    const double span = t.back() - t.front();
    const double slope = span > 0 ? (x.back() - x.front()) / span : 0.0;
    return {x.front() + slope * (at - t.front()), slope, 0.0};
  }
  // Normal equations in s = (t - at)/scale, so that powers stay near one; x relative to its first
  // value, so that a large angle costs no digits.
  double moment[7] = {}, right[4] = {};
  for (std::size_t i = 0; i < n; ++i) {
    const double s = (t[i] - at) / scale;
    const double y = x[i] - x.front();
    double power = 1.0;
    for (int p = 0; p < 7; ++p) {
      moment[p] += power;
      if (p < 4) right[p] += power * y;
      power *= s;
    }
  }
  Eigen::Matrix4d normal;
  for (int r = 0; r < 4; ++r)
    for (int c = 0; c < 4; ++c) normal(r, c) = moment[r + c];
  const Eigen::Vector4d b = normal.ldlt().solve(Eigen::Map<Eigen::Vector4d>(right));
  return {b[0] + x.front(), b[1] / scale, 2.0 * b[2] / (scale * scale)};
}

Kinematics differentiate(std::span<const double> t, std::span<const double> x,
                         double half_width_s) {
  const std::size_t n = t.size();
  Kinematics out{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  std::size_t first = 0, last = 0;  // window [first, last)
  for (std::size_t i = 0; i < n; ++i) {
    while (t[first] < t[i] - half_width_s) ++first;
    last = std::max(last, i);
    while (last < n && t[last] <= t[i] + half_width_s) ++last;
    std::size_t from = first, to = last;
    while (to - from < 5 && (from > 0 || to < n)) {  // sparse data: the nearest, not across a gap
      const bool back = to == n || (from > 0 && t[i] - t[from - 1] <= t[to] - t[i]);
      back ? --from : ++to;
    }
    const auto d = local_cubic(t.subspan(from, to - from), x.subspan(from, to - from), t[i]);
    out.value[i] = d.value;
    out.first[i] = d.first;
    out.second[i] = d.second;
  }
  return out;
}

}  // namespace searig::estimator
