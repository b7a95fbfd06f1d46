// The few primitives that the pictures are made of, whatever they are written as.
#pragma once

#include <string_view>
#include <utility>
#include <vector>

#include "app/report/plot.h"

namespace searig::app {

using Points = std::vector<std::pair<double, double>>;  ///< in pixels

enum class Anchor { start, middle, end };
enum class Stroke { thin, thick, dashed, dotted };

/// `paint` is the name of a shade in palette.h: a hue, "grid", "faint" or "ground". All lengths are
/// in pixels, y goes downwards.
class Canvas {
 public:
  virtual ~Canvas() = default;

  virtual void line(double x1, double y1, double x2, double y2, std::string_view paint,
                    Stroke stroke = Stroke::thin) = 0;
  virtual void rectangle(double x, double y, double width, double height, std::string_view paint,
                         double opacity = 1.0) = 0;
  virtual void polyline(const Points& points, std::string_view paint) = 0;
  virtual void polygon(const Points& points, std::string_view paint, double opacity) = 0;
  virtual void dots(const Points& points, std::string_view paint, double diameter = 3.0) = 0;
  /// `kind` is "t" for a title, "f" for faint, else ink.
  virtual void text(double x, double y, std::string_view words, Anchor anchor = Anchor::start,
                    std::string_view kind = {}) = 0;
  /// Written from below to above, centred on (x, y).
  virtual void text_upwards(double x, double y, std::string_view words) = 0;
  /// What follows until end_clip() is cut to this rectangle.
  virtual void begin_clip(double x, double y, double width, double height) = 0;
  virtual void end_clip() = 0;
};

/// A plot on any canvas.
void draw(Canvas& canvas, const Plot& plot, Size size);

/// About how wide a text comes out; browsers differ, so this is on the safe side.
double text_width(std::string_view words, double font_px = 12.0);

}  // namespace searig::app
