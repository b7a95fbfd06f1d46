// The reports' pictures on a widget, in the window's colours.
#pragma once

#include <QPainter>

#include "app/desktop/theme.h"
#include "app/report/canvas.h"

namespace searig::app::desktop {

class PainterCanvas final : public Canvas {
 public:
  PainterCanvas(QPainter& painter, const Theme& theme);

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

 private:
  QColor colour(std::string_view paint) const;

  QPainter& painter_;
  Theme theme_;
};

}  // namespace searig::app::desktop
