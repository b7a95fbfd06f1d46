#include "app/report/decimate.h"

#include <algorithm>
#include <cmath>

namespace searig::app {
namespace {

/// The four points that stand for all points of one pixel column.
struct Column {
  std::size_t first, lowest, highest, last;

  explicit Column(std::size_t i) : first(i), lowest(i), highest(i), last(i) {}

  void add(std::size_t i, const std::vector<double>& y) {
    if (y[i] < y[lowest]) lowest = i;
    if (y[i] > y[highest]) highest = i;
    last = i;
  }

  void write(std::vector<std::size_t>& out) const {
    const auto [a, b] = std::minmax(lowest, highest);
    for (const std::size_t i : {first, a, b, last}) {
      if (out.empty() || out.back() != i) out.push_back(i);
    }
  }
};

}  // namespace

std::vector<std::size_t> decimate(const std::vector<double>& x, const std::vector<double>& y,
                                  double low, double high, std::size_t columns) {
  std::vector<std::size_t> out;
  const std::size_t size = std::min(x.size(), y.size());
  if (size == 0 || columns == 0 || !(high > low)) return out;
  const auto stop = x.begin() + static_cast<std::ptrdiff_t>(size);
  const auto begin_at = std::lower_bound(x.begin(), stop, low) - x.begin();
  const auto end_at = std::upper_bound(x.begin() + begin_at, stop, high) - x.begin();
  const std::size_t begin = begin_at > 0 ? static_cast<std::size_t>(begin_at) - 1 : 0;
  const std::size_t end = std::min(size, static_cast<std::size_t>(end_at) + 1);

  const double per_column = (high - low) / static_cast<double>(columns);
  double edge = low;  // right end of the pixel column being gathered
  bool open = false;
  Column column(begin);
  for (std::size_t i = begin; i < end; ++i) {
    if (!std::isfinite(y[i])) {
      if (open) column.write(out);
      if (open) out.push_back(i);
      open = false;
    } else if (!open || x[i] >= edge) {
      if (open) column.write(out);
      column = Column(i);
      open = true;
      edge = low + per_column * (std::floor((x[i] - low) / per_column) + 1.0);
    } else {
      column.add(i, y);
    }
  }
  if (open) column.write(out);
  return out;
}

}  // namespace searig::app
