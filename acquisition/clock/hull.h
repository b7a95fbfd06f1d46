// Pure geometry: the lower convex hull of points and the line that lies under all of them.
#pragma once

#include <cstddef>
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

/// Indices of the lower convex hull, left to right (Andrew's monotone chain). x must not fall.
std::vector<std::size_t> lower_hull(std::span<const double> x, std::span<const double> y);

/// Of all lines below every point the one closest to them on average: the hull's edge under the
/// mean of x. For delays that are exponential above a floor it is the maximum-likelihood floor
/// (Moon, Skelly and Towsley 1999; Zhang, Liu and Xia 2002). x must not fall; at least one point;
/// a single point, or points all at one x, give a level line.
Line line_under(std::span<const double> x, std::span<const double> y);

/// The highest line of that slope below every point, at x = at.
Line line_under(std::span<const double> x, std::span<const double> y, double slope, double at);

}  // namespace searig::acquisition
