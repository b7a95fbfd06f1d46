#include "app/desktop/painter_canvas.h"

#include <QPolygonF>

namespace searig::app::desktop {
namespace {

QPolygonF polygon_of(const Points& points) {
  QPolygonF out;
  for (const auto& [x, y] : points) out << QPointF(x, y);
  return out;
}

QString text_of(std::string_view words) {
  return QString::fromUtf8(words.data(), int(words.size()));
}

}  // namespace

PainterCanvas::PainterCanvas(QPainter& painter, const Theme& theme)
    : painter_(painter), theme_(theme) {
  painter_.setRenderHint(QPainter::Antialiasing);
}

QColor PainterCanvas::colour(std::string_view paint) const {
  for (const Shades& shade : hues)
    if (shade.name == paint) return theme_.colour(shade);
  for (const Shades& shade : {ground, grid, faint})
    if (shade.name == paint) return theme_.colour(shade);
  return theme_.colour(Hue::ink);
}

void PainterCanvas::line(double x1, double y1, double x2, double y2, std::string_view paint,
                         Stroke stroke) {
  const Qt::PenStyle style = stroke == Stroke::dashed   ? Qt::DashLine
                             : stroke == Stroke::dotted ? Qt::DotLine
                                                        : Qt::SolidLine;
  painter_.setPen(QPen(colour(paint), stroke == Stroke::thick ? 2.0 : 1.0, style));
  painter_.drawLine(QPointF(x1, y1), QPointF(x2, y2));
}

void PainterCanvas::rectangle(double x, double y, double width, double height,
                              std::string_view paint, double opacity) {
  QColor fill = colour(paint);
  fill.setAlphaF(opacity);
  painter_.fillRect(QRectF(x, y, width, height), fill);
}

void PainterCanvas::polyline(const Points& points, std::string_view paint) {
  painter_.setPen(QPen(colour(paint), 1.4));
  painter_.drawPolyline(polygon_of(points));
}

void PainterCanvas::polygon(const Points& points, std::string_view paint, double opacity) {
  QColor fill = colour(paint);
  fill.setAlphaF(opacity);
  painter_.setPen(Qt::NoPen);
  painter_.setBrush(fill);
  painter_.drawPolygon(polygon_of(points));
}

void PainterCanvas::dots(const Points& points, std::string_view paint, double diameter) {
  painter_.setPen(QPen(colour(paint), diameter, Qt::SolidLine, Qt::RoundCap));
  painter_.drawPoints(polygon_of(points));
}

void PainterCanvas::text(double x, double y, std::string_view words, Anchor anchor,
                         std::string_view kind) {
  QFont font = painter_.font();
  font.setPixelSize(kind == "t" ? 14 : 12);
  font.setBold(kind == "t");
  painter_.setFont(font);
  painter_.setPen(colour(kind == "f" ? "faint" : "ink"));
  const QString text = text_of(words);
  const double width = QFontMetricsF(font).horizontalAdvance(text);
  constexpr double shares[] = {0.0, 0.5, 1.0};
  painter_.drawText(QPointF(x - shares[static_cast<int>(anchor)] * width, y), text);
}

void PainterCanvas::text_upwards(double x, double y, std::string_view words) {
  painter_.save();
  painter_.translate(x, y);
  painter_.rotate(-90.0);
  text(0.0, 0.0, words, Anchor::middle);
  painter_.restore();
}

void PainterCanvas::begin_clip(double x, double y, double width, double height) {
  painter_.save();
  painter_.setClipRect(QRectF(x, y, width, height), Qt::IntersectClip);
}

void PainterCanvas::end_clip() {
  painter_.restore();
}

}  // namespace searig::app::desktop
