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

Window window_about(std::span<const double> t, std::size_t centre, double half_width_s) {
  constexpr std::size_t least = 5;  // that a cubic with something to average needs
  Window w{centre, centre + 1};
  while (w.from > 0 && t[w.from - 1] >= t[centre] - half_width_s) --w.from;
  while (w.to < t.size() && t[w.to] <= t[centre] + half_width_s) ++w.to;
  while (w.to - w.from < least && (w.from > 0 || w.to < t.size())) {
    const bool back =
        w.to == t.size() || (w.from > 0 && t[centre] - t[w.from - 1] <= t[w.to] - t[centre]);
    back ? --w.from : ++w.to;
  }
  return w;
}

Derivatives derivatives_at(std::span<const double> t, std::span<const double> x, std::size_t centre,
                           double half_width_s) {
  const auto [from, to] = window_about(t, centre, half_width_s);
  return local_cubic(t.subspan(from, to - from), x.subspan(from, to - from), t[centre]);
}

Kinematics differentiate(std::span<const double> t, std::span<const double> x,
                         double half_width_s) {
  const std::size_t n = t.size();
  Kinematics out{std::vector<double>(n), std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < n; ++i) {
    const auto d = derivatives_at(t, x, i, half_width_s);
    out.value[i] = d.value;
    out.first[i] = d.first;
    out.second[i] = d.second;
  }
  return out;
}

}  // namespace searig::estimator
