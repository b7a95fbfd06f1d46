#include "app/report/svg.h"

#include "app/report/svg_canvas.h"

namespace searig::app {

std::string to_svg(const Plot& plot, Size size) {
  SvgCanvas canvas(size, plot.title);
  draw(canvas, plot, size);
  return std::move(canvas).finish();
}

}  // namespace searig::app
