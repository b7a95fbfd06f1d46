#include "app/report/column_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searig::app {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Range nothing{infinity, -infinity};

Range only(double y) {
  return std::isfinite(y) ? Range{y, y} : Range{unknown, unknown};
}

/// NaN stays NaN.
void join(Range& all, const Range& more) {
  all.low = more.low >= all.low ? all.low : more.low;
  all.high = more.high <= all.high ? all.high : more.high;
}

/// Blocks of `fan` of what is finer, as far as they are full.
template <typename At>
void grow(std::vector<Range>& blocks, std::size_t fan, std::size_t finer, At at) {
  for (std::size_t n = blocks.size(); fan * (n + 1) <= finer; ++n) {
    Range block = at(fan * n);
    for (std::size_t i = 1; i < fan && !std::isnan(block.low); ++i) join(block, at(fan * n + i));
    blocks.push_back(block);
  }
}

/// The first place behind `from` with x >= edge; looked for in growing steps, as it is near.
std::size_t behind(const std::vector<double>& x, std::size_t from, std::size_t end, double edge) {
  std::size_t step = 1;
  while (from + step < end && x[from + step] < edge) step *= 2;
  const auto place = [&](std::size_t i) { return x.begin() + static_cast<std::ptrdiff_t>(i); };
  return static_cast<std::size_t>(
      std::lower_bound(place(from + step / 2), place(std::min(end, from + step)), edge) -
      x.begin());
}

/// Gathers what covers the columns.
class Cover {
 public:
  Cover(Range view, std::vector<Range>& spans)
      : low_(view.low), width_((view.high - view.low) / double(spans.size())), spans_(spans) {}

  double right_edge_at(double x) const {
    return low_ + width_ * (std::floor((x - low_) / width_) + 1.0);
  }

  void points(double x, const Range& range) {
    const double column = std::floor((x - low_) / width_);
    if (column >= 0.0 && column < double(spans_.size()))
      join(spans_[static_cast<std::size_t>(column)], range);
  }

  /// The straight line between two points, column by column.
  void line(double x1, double y1, double x2, double y2) {
    const double last = double(spans_.size()) - 1.0;
    const double from = std::clamp(std::floor((x1 - low_) / width_), 0.0, last);
    const double to = std::clamp(std::floor((x2 - low_) / width_), 0.0, last);
    if (!(x2 > x1)) return;
    const auto at = [&](double x) {
      return y1 + (y2 - y1) * (std::clamp(x, x1, x2) - x1) / (x2 - x1);
    };
    for (double column = from; column <= to; ++column) {
      const double left = low_ + width_ * column, right = left + width_;
      if (right < x1 || left > x2) continue;
      const auto [low, high] = std::minmax({at(left), at(right)});
      join(spans_[static_cast<std::size_t>(column)], {low, high});
    }
  }

 private:
  double low_, width_;
  std::vector<Range>& spans_;
};

}  // namespace

void Extremes::clear() {
  for (auto& level : blocks_) level.clear();
}

void Extremes::follow(const std::vector<double>& y) {
  grow(blocks_[0], block, y.size(), [&](std::size_t i) { return only(y[i]); });
  for (std::size_t level = 1; level < levels; ++level) {
    const auto& finer = blocks_[level - 1];
    grow(blocks_[level], fan, finer.size(), [&](std::size_t i) { return finer[i]; });
  }
}

/// From the finest blocks upwards as long as a whole coarser block fits, then down again.
Range Extremes::in(const std::vector<double>& y, std::size_t first, std::size_t last) const {
  Range all = only(y[first]);
  for (std::size_t i = first + 1; i < last && !std::isnan(all.low);) {
    std::size_t level = 0, size = 1;  // of the largest block that begins here and ends in time
    for (std::size_t next = block; level < levels && i % next == 0 && i + next <= last;
         next = size * fan) {
      size = next;
      ++level;
    }
    join(all, level == 0 ? only(y[i]) : blocks_[level - 1][i / size]);
    i += size;
  }
  return all;
}

void column_spans(const std::vector<double>& x, const std::vector<double>& y,
                  const Extremes& extremes, Range view, std::size_t columns, Joined joined,
                  std::vector<Range>& spans) {
  spans.assign(columns, nothing);
  const std::size_t size = std::min(x.size(), y.size());
  if (size == 0 || columns == 0 || !(view.high > view.low)) return;
  const auto stop = x.begin() + static_cast<std::ptrdiff_t>(size);
  const auto begin_at = std::lower_bound(x.begin(), stop, view.low) - x.begin();
  const auto end_at = std::upper_bound(x.begin() + begin_at, stop, view.high) - x.begin();
  // One point beyond each end, so that the line leaves the picture.
  const std::size_t begin = begin_at > 0 ? static_cast<std::size_t>(begin_at) - 1 : 0;
  const std::size_t end = std::min(size, static_cast<std::size_t>(end_at) + 1);

  Cover cover(view, spans);
  const auto join_before = [&](std::size_t i) {
    if (joined == Joined::yes && i > begin && std::isfinite(y[i - 1]))
      cover.line(x[i - 1], y[i - 1], x[i], y[i]);
  };
  for (std::size_t i = begin; i < end;) {
    std::size_t next = std::max(i + 1, behind(x, i, end, cover.right_edge_at(x[i])));
    // Where a column holds very many, its edge may as well be that of a block: nobody sees a
    // sixteenth of a pixel, and single values need not be looked at.
    if (next < end && next - i > 16 * Extremes::block) next -= next % Extremes::block;
    if (const Range all = extremes.in(y, i, next); !std::isnan(all.low)) {
      join_before(i);
      cover.points(x[i], all);
    } else {
      for (std::size_t j = i; j < next; ++j) {
        if (!std::isfinite(y[j])) continue;
        join_before(j);
        cover.points(x[j], only(y[j]));
      }
    }
    i = next;
  }
}

}  // namespace searig::app
