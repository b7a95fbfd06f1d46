// A canvas that becomes SVG text.
#pragma once

#include <string>
#include <string_view>

#include "app/report/canvas.h"

namespace searig::app {

class SvgCanvas final : public Canvas {
 public:
  SvgCanvas(Size size, std::string_view title);

  void line(double x1, double y1, double x2, double y2, std::string_view paint,
            Stroke stroke = Stroke::thin) override;
  void rectangle(double x, double y, double width, double height, std::string_view paint,
                 double opacity = 1.0) override;
  void polyline(const Points& points, std::string_view paint) override;
  void polygon(const Points& points, std::string_view paint, double opacity) override;
  void dots(const Points& points, std::string_view paint, double diameter = 3.0) override;
  void text(double x, double y, std::string_view words, Anchor anchor = Anchor::start,
            std::string_view kind = {}) override;
  void text_upwards(double x, double y, std::string_view words) override;
  void begin_clip(double x, double y, double width, double height) override;
  void end_clip() override;

  std::string finish() &&;

 private:
  std::string out_;
};

}  // namespace searig::app
