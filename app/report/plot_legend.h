// The legend of a plot.
#pragma once

#include "app/report/canvas.h"
#include "app/report/plot.h"

namespace searig::app {

/// Draws the legend above the data, where it can cover none; returns the height it took.
double draw_legend(Canvas& canvas, const Plot& plot, double left, double top, double right);

}  // namespace searig::app
