#include "app/report/svg.h"

#include "app/report/svg_canvas.h"

namespace searig::app {

std::string to_svg(const Plot& plot, Size size) {
  SvgCanvas canvas(size, plot.title);
  draw(canvas, plot, size);
  return std::move(canvas).finish();
}

std::string to_svg(const std::vector<Plot>& plots, Size each) {
  const auto height = [&](std::size_t of) {
    return std::to_string(each.height * static_cast<int>(of));
  };
  const std::string width = std::to_string(each.width), opening = "<svg ";
  std::string out = opening + "xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + width + " " +
                    height(plots.size()) + "\" width=\"" + width + "\" height=\"" +
                    height(plots.size()) + "\">\n";
  for (std::size_t i = 0; i < plots.size(); ++i)
    out += opening + "y=\"" + height(i) + "\" " + to_svg(plots[i], each).substr(opening.size());
  return out + "</svg>\n";
}

}  // namespace searig::app
