#include "app/desktop/plot/span_item.h"

#include <qwt_scale_map.h>

#include <QPainter>
#include <algorithm>
#include <cmath>
#include <limits>

namespace searig::app::desktop {
namespace {

constexpr double line_width = 1.3, dot_size = 3.0;  // logical pixels
constexpr Range nothing{std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity()};

void join(Range& all, const Range& more) {
  all.low = std::min(all.low, more.low);
  all.high = std::max(all.high, more.high);
}

}  // namespace

std::size_t SpanItem::add(Kind kind) {
  curves_.push_back({kind, {}, nullptr, {}, {}});
  return curves_.size() - 1;
}

void SpanItem::set_data(std::size_t curve, const std::vector<double>* x,
                        const std::vector<double>* y, const std::vector<double>* high) {
  curves_[curve].x = x;
  curves_[curve].side = {y, {}, {}};
  curves_[curve].high = {high, {}, {}};
}

void SpanItem::choose(Range x, std::size_t columns) {
  x_ = x;
  columns_ = columns;
  const double half = columns > 1 ? 0.5 * (x.high - x.low) / double(columns - 1) : 0.0;
  const Range edges = snapped({x.low - half, x.high + half}, columns);
  for (Curve& curve : curves_)
    for (Side* side : {&curve.side, &curve.high}) {
      if (curve.x == nullptr || side->y == nullptr) continue;
      side->extremes.follow(*side->y);
      side->spans.follow(*curve.x, *side->y, side->extremes, edges, columns,
                         curve.kind == Kind::dots ? Joined::no : Joined::yes);
    }
}

Range SpanItem::y_range(std::size_t curve) const {
  Range all = nothing;
  for (const Side* side : {&curves_[curve].side, &curves_[curve].high})
    for (const Range& span : side->spans.spans()) join(all, span);
  return all;
}

Range SpanItem::y_range() const {
  Range all = nothing;
  for (std::size_t curve = 0; curve < curves_.size(); ++curve) join(all, y_range(curve));
  return all;
}

void SpanItem::draw(QPainter* painter, const QwtScaleMap&, const QwtScaleMap& y_map,
                    const QRectF& canvas) const {
  const double scale = painter->device()->devicePixelRatioF();
  const QSize pixels(int(std::lround(canvas.width() * scale)),
                     int(std::lround(canvas.height() * scale)));
  if (pixels.isEmpty()) return;
  // The canvas has been given another size since what covers its columns was worked out.
  if (std::size_t(pixels.width()) != columns_)
    const_cast<SpanItem*>(this)->choose(x_, std::size_t(pixels.width()));
  // Qwt's values stand at the middles of pixels.
  image_.begin(pixels,
               {y_map.invTransform(canvas.bottom() - 0.5), y_map.invTransform(canvas.top() - 0.5)},
               scale);
  for (const Curve& curve : curves_) {
    if (curve.kind == Kind::band)
      image_.area(curve.side.spans.spans(), curve.high.spans.spans(), curve.colour);
    else
      image_.line(curve.side.spans.spans(), curve.colour,
                  curve.kind == Kind::dots ? dot_size : line_width);
  }
  // Pixel by pixel: Qt scales an image that is given in logical ones, if only by one to one.
  painter->save();
  painter->scale(1.0 / scale, 1.0 / scale);
  painter->drawImage(QPointF(std::round(canvas.left() * scale), std::round(canvas.top() * scale)),
                     image_.image());
  painter->restore();
}

}  // namespace searig::app::desktop
