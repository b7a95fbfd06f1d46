// A plot as SVG text: stands alone as a file, or inside a page.
#pragma once

#include <string>
#include <string_view>

#include "app/report/plot.h"

namespace searig::app {

std::string to_svg(const Plot& plot, Size size = {});
std::string to_svg(const CellMap& map, int width = 900);

/// Text made safe inside XML and HTML.
std::string escape(std::string_view text);

}  // namespace searig::app
