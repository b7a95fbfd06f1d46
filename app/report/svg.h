// A plot as SVG text: stands alone as a file, or inside a page.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/report/plot.h"

namespace searig::app {

std::string to_svg(const Plot& plot, Size size = {});
/// One below the other, each as large.
std::string to_svg(const std::vector<Plot>& plots, Size each = {});
std::string to_svg(const CellMap& map, int width = 900);

/// Text made safe inside XML and HTML.
std::string escape(std::string_view text);

}  // namespace searig::app
