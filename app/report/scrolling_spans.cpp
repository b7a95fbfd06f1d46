#include "app/report/scrolling_spans.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searig::app {
namespace {

constexpr double alike = 1e-3;  // of a column: what rounding moves an edge by at most

}  // namespace

Range snapped(Range view, std::size_t columns) {
  const double width = (view.high - view.low) / double(columns);
  if (!(width > 0.0)) return view;
  const double low = width * std::round(view.low / width);
  return {low, low + width * double(columns)};
}

/// How many columns at the left are those of the last time. Of these, the one that held the last
/// point may have got more since, and the line from there crosses the next.
std::size_t ScrollingSpans::kept(Range view, std::size_t columns, double width) {
  if (spans_.size() != columns || columns < 4) return 0;
  const double last_width = (view_.high - view_.low) / double(columns);
  const double shift = (view.low - view_.low) / width;
  const bool same = std::abs(width - last_width) * double(columns) < alike * width &&
                    std::abs(shift - std::round(shift)) < alike;
  if (!same || shift < -0.5 || shift > double(columns)) return 0;
  const double whole =
      std::clamp(std::floor((known_to_ - view_.low) / width) - 1.0, 0.0, double(columns) - 2.0);
  const double moved = std::round(shift);
  if (whole <= moved) return 0;
  spans_.erase(spans_.begin(), spans_.begin() + std::ptrdiff_t(moved));
  return std::size_t(whole - moved);
}

const std::vector<Range>& ScrollingSpans::follow(const std::vector<double>& x,
                                                 const std::vector<double>& y,
                                                 const Extremes& extremes, Range view,
                                                 std::size_t columns, Joined joined) {
  const double width = (view.high - view.low) / double(columns);
  if (const std::size_t kept_columns = kept(view, columns, width)) {
    const double from = view.low + width * double(kept_columns);
    column_spans(x, y, extremes, {from, view.high}, columns - kept_columns, joined, fresh_);
    spans_.resize(kept_columns);
    spans_.insert(spans_.end(), fresh_.begin(), fresh_.end());
  } else {
    column_spans(x, y, extremes, view, columns, joined, spans_);
  }
  view_ = view;
  const std::size_t size = std::min(x.size(), y.size());
  known_to_ = size > 0 ? x[size - 1] : -std::numeric_limits<double>::infinity();
  return spans_;
}

}  // namespace searig::app
