#include "app/desktop/plot/decimated_series.h"

#include <algorithm>
#include <cmath>

#include "app/report/decimate.h"

namespace searig::app::desktop {

void DecimatedSeries::show(const std::vector<double>* x, const std::vector<double>* y) {
  x_ = x;
  y_ = y;
  points_.clear();
  bounds_ = {};
}

void DecimatedSeries::choose(double low, double high, int pixel_columns) {
  points_.clear();
  bounds_ = {};
  if (x_ == nullptr || y_ == nullptr || pixel_columns < 1) return;
  for (const auto i : decimate(*x_, *y_, low, high, static_cast<std::size_t>(pixel_columns))) {
    if (std::isfinite((*y_)[i])) points_.emplace_back((*x_)[i], (*y_)[i]);
  }
  if (points_.empty()) return;
  const auto [lowest, highest] = std::minmax_element(points_.begin(), points_.end(),
                                                     [](auto a, auto b) { return a.y() < b.y(); });
  bounds_ = QRectF(points_.front().x(), lowest->y(), points_.back().x() - points_.front().x(),
                   highest->y() - lowest->y());
}

}  // namespace searig::app::desktop
