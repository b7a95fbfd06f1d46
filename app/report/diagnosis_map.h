// The mismatch map: for each channel, in which part of its range the simulation is off, before and
// after.
#pragma once

#include <string>
#include <vector>

#include "app/report/canvas.h"
#include "estimator/diagnosis/diagnosis.h"

namespace searig::app {

/// The cells of one residual ("loadcell-spring", "drive-spring") as SVG: for each channel a strip
/// before and a strip after. Empty where the map has no cell of it. `both` is false where nothing
/// was found, so that there is one strip only.
std::string mismatch_map(const std::vector<estimator::Cell>& cells, const std::string& residual,
                         const std::string& title, bool both, int width = 900);

/// The same on any canvas, as high as map_height() says; 0: there is none.
void draw_mismatch_map(Canvas& canvas, const std::vector<estimator::Cell>& cells,
                       const std::string& residual, const std::string& title, bool both, int width);
int map_height(const std::vector<estimator::Cell>& cells, const std::string& residual, bool both);

}  // namespace searig::app
