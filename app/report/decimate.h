// As many points as a screen can show, with every peak still there.
#pragma once

#include <cstddef>
#include <vector>

namespace searig::app {

/// Indices of the points to draw of a line with rising x between `low` and `high`, drawn `columns`
/// pixels wide: of each pixel column the first, the lowest, the highest and the last point, and
/// one point beyond each end so that the line leaves the picture. Points that are not finite stay,
/// so that they break the line. At most 4 * columns + 2 finite points come back.
std::vector<std::size_t> decimate(const std::vector<double>& x, const std::vector<double>& y,
                                  double low, double high, std::size_t columns);

}  // namespace searig::app
