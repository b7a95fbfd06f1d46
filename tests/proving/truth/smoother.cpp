#include "tests/proving/truth/smoother.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace searig::proving {

Smoothed smooth_at(const std::vector<double>& at_s, const std::vector<double>& t_s,
                   const std::vector<double>& y, double sigma_s) {
  Smoothed out;
  const double reach = 3.5 * sigma_s;
  for (const double at : at_s) {
    auto from = std::lower_bound(t_s.begin(), t_s.end(), at - reach) - t_s.begin();
    auto to = std::upper_bound(t_s.begin(), t_s.end(), at + reach) - t_s.begin();
    const auto size = static_cast<std::ptrdiff_t>(t_s.size());
    while (to - from < 6) {  // a gap: look further to both sides
      from = std::max<std::ptrdiff_t>(0, from - 1);
      to = std::min(size, to + 1);
    }
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (auto i = from; i < to; ++i) {
      const double u = (t_s[static_cast<std::size_t>(i)] - at) / sigma_s;
      const Eigen::Vector4d basis(1.0, u, u * u, u * u * u);
      const double weight = std::exp(-0.5 * std::min(u * u, 20.0));
      normal += weight * basis * basis.transpose();
      right += weight * y[static_cast<std::size_t>(i)] * basis;
    }
    const Eigen::Vector4d c = normal.ldlt().solve(right);
    out.value.push_back(c[0]);
    out.rate.push_back(c[1] / sigma_s);
    out.acceleration.push_back(2.0 * c[2] / (sigma_s * sigma_s));
  }
  return out;
}

}  // namespace searig::proving
