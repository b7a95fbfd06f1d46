// Pure geometry: the lower convex hull of points and the line that lies under all of them.
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace searig::acquisition {

/// y = value at x = at, rising by slope.
struct Line {
  double at = 0.0;
  double value = 0.0;
  double slope = 0.0;

  double operator()(double x) const { return value + slope * (x - at); }
};

/// Indices of the lower convex hull, left to right (Andrew's monotone chain). x must not fall; y[i]
/// is a number, from a span or worked out.
template <class Y>
std::vector<std::size_t> lower_hull(std::span<const double> x, const Y& y) {
  std::vector<std::size_t> hull;
  for (std::size_t i = 0; i < x.size(); ++i) {
    // A point stays only while the way over it turns left; of points at one x the lowest stays.
    while (!hull.empty()) {
      const std::size_t b = hull.back();
      if (x[i] == x[b]) {
        if (y[i] >= y[b]) break;
        hull.pop_back();
        continue;
      }
      if (hull.size() == 1) break;
      const std::size_t a = hull[hull.size() - 2];
      if ((x[b] - x[a]) * (y[i] - y[a]) > (y[b] - y[a]) * (x[i] - x[a])) break;
      hull.pop_back();
    }
    if (hull.empty() || x[i] != x[hull.back()]) hull.push_back(i);
  }
  return hull;
}

/// Of all lines below every point the one closest to them on average: the hull's edge under the
/// mean of x. For delays that are exponential above a floor it is the maximum-likelihood floor
/// (Moon, Skelly and Towsley 1999; Zhang, Liu and Xia 2002). x must not fall; at least one point;
/// a single point, or points all at one x, give a level line.
template <class Y>
Line line_under(std::span<const double> x, const Y& y) {
  const double mean =
      std::accumulate(x.begin(), x.end(), 0.0,
                      [&](double sum, double value) {
                        return sum + (value - x[0]);  // near zero, so that no digits are lost
                      }) /
          static_cast<double>(x.size()) +
      x[0];
  const std::vector<std::size_t> hull = lower_hull(x, y);
  if (hull.size() < 2) return {x[hull[0]], y[hull[0]], 0.0};
  const auto right =
      std::find_if(hull.begin() + 1, hull.end() - 1, [&](std::size_t i) { return x[i] >= mean; });
  const std::size_t b = *right, a = *(right - 1);
  const double slope = (y[b] - y[a]) / (x[b] - x[a]);
  return {mean, y[a] + slope * (mean - x[a]), slope};
}

/// The highest line of that slope below every point, at x = at.
template <class Y>
Line line_under(std::span<const double> x, const Y& y, double slope, double at) {
  double value = y[0] + slope * (at - x[0]);
  for (std::size_t i = 1; i < x.size(); ++i) value = std::min(value, y[i] + slope * (at - x[i]));
  return {at, value, slope};
}

}  // namespace searig::acquisition
