// Where the data of a plot are drawn, and on which axes.
#pragma once

#include "app/report/axis.h"
#include "app/report/plot.h"

namespace searig::app {

inline constexpr double margin_px = 12.0;  ///< around a plot

/// The rectangle the data are drawn in, and both axes.
struct Frame {
  double left, top, width, height;
  Axis x, y;

  double to_x(double value) const {
    return left + width * (value - x.range.low) / (x.range.high - x.range.low);
  }
  double to_y(double value) const {
    return top + height * (y.range.high - value) / (y.range.high - y.range.low);
  }
};

/// Below `top`, with as many ticks as there is room for.
Frame lay_out(const Plot& plot, Size size, double top);

}  // namespace searig::app
