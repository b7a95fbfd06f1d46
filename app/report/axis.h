// Where the ticks of an axis go and how they are written.
#pragma once

#include <string>
#include <vector>

#include "app/report/plot.h"

namespace searig::app {

struct Axis {
  Range range;                ///< what the axis shows
  std::vector<double> ticks;  ///< at round numbers within the range
  int decimals = 0;           ///< that tell neighbouring ticks apart
  int exponent = 0;           ///< ticks are written divided by 10^exponent

  std::string label(double tick) const;
};

/// Ticks at 1, 2 or 5 times a power of ten, about `wanted` of them, within `range` as given.
Axis make_axis(Range range, int wanted);

/// The range of the finite values, widened by `margin` of it; [0, 1] where there are none.
Range span_of(const std::vector<const std::vector<double>*>& values, double margin);

/// A number as people write it: `decimals` digits, a true minus sign.
std::string number(double value, int decimals);

}  // namespace searig::app
