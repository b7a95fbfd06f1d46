// What a line covers of each pixel column, while the view moves on with data that grow.
#pragma once

#include <vector>

#include "app/report/column_spans.h"

namespace searig::app {

/// column_spans() again and again: columns that only moved to the left are not worked out anew, so
/// that a frame costs what is new in it. Between calls x and y may be appended to; whatever else
/// changes in them, clear().
class ScrollingSpans {
 public:
  void clear() { spans_.clear(); }

  /// Columns stay where views are snapped() and as wide as before.
  const std::vector<Range>& follow(const std::vector<double>& x, const std::vector<double>& y,
                                   const Extremes& extremes, Range view, std::size_t columns,
                                   Joined joined);
  const std::vector<Range>& spans() const { return spans_; }

 private:
  std::size_t kept(Range view, std::size_t columns, double width);

  std::vector<Range> spans_, fresh_;
  Range view_;
  double known_to_;  ///< the last x that was seen
};

/// The view with its edges on the nearest multiples of a column's width, so that the columns of a
/// view that moves are always the same ones.
Range snapped(Range view, std::size_t columns);

}  // namespace searig::app
