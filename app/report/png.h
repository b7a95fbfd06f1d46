// A plot as a PNG file, without a display: light colours, DejaVu Sans.
#pragma once

#include <filesystem>

#include "app/report/plot.h"

namespace searig::app {

/// Every length of `size` becomes `scale` pixels. Throws std::runtime_error with one sentence where
/// the file cannot be written.
void write_png(const Plot& plot, const std::filesystem::path& file, Size size = {},
               double scale = 2.0);

}  // namespace searig::app
