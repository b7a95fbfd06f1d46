// The few SVG primitives that the pictures are made of.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/report/svg.h"

namespace searig::app {

using Points = std::vector<std::pair<double, double>>;  ///< in pixels

enum class Anchor { start, middle, end };

class Canvas {
 public:
  Canvas(Size size, std::string_view title);

  /// `paint` is a name from the style sheet: a hue, "grid", "faint" or "ground".
  void line(double x1, double y1, double x2, double y2, std::string_view paint,
            std::string_view extra = {});
  void rectangle(double x, double y, double width, double height, std::string_view paint,
                 double opacity = 1.0);
  void polyline(const Points& points, std::string_view paint);
  void polygon(const Points& points, std::string_view paint, double opacity);
  void dots(const Points& points, std::string_view paint);
  void text(double x, double y, std::string_view words, Anchor anchor = Anchor::start,
            std::string_view css_class = {});
  /// Written from below to above, centred on (x, y).
  void text_upwards(double x, double y, std::string_view words);
  /// What follows until end_clip() is cut to this rectangle.
  void begin_clip(double x, double y, double width, double height);
  void end_clip() { out_ += "</g>\n"; }

  std::string finish() &&;

 private:
  std::string out_;
};

/// About how wide a text comes out; browsers differ, so this is on the safe side.
double text_width(std::string_view words, double font_px = 12.0);

}  // namespace searig::app
