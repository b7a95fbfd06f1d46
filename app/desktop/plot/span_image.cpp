#include "app/desktop/plot/span_image.h"

#include <algorithm>
#include <cmath>

namespace searig::app::desktop {
namespace {

/// One premultiplied colour over another; cover is 0 to 256.
inline void blend(QRgb& under, QRgb over, unsigned cover) {
  const auto scaled = [](QRgb colour, unsigned by) {
    const QRgb odd = ((colour >> 8) & 0x00ff00ffU) * by;
    const QRgb even = (colour & 0x00ff00ffU) * by;
    return (odd & 0xff00ff00U) | ((even >> 8) & 0x00ff00ffU);
  };
  const QRgb top = scaled(over, cover);
  under = top + scaled(under, 256U - qAlpha(top) - (qAlpha(top) >> 7));
}

}  // namespace

void SpanImage::begin(QSize pixels, Range y, double scale) {
  if (image_.size() != pixels) image_ = QImage(pixels, QImage::Format_ARGB32_Premultiplied);
  image_.fill(Qt::transparent);
  y_ = y;
  scale_ = scale;
  rows_per_y_ = double(pixels.height()) / std::max(1e-300, y.high - y.low);
}

/// Rows at the ends are covered in part: that smooths lines that are nearly level.
void SpanImage::fill(int column, double top, double bottom, const QColor& colour) {
  top = std::clamp(top, 0.0, double(image_.height()));
  bottom = std::clamp(bottom, 0.0, double(image_.height()));
  if (!(bottom > top)) return;
  const QRgb paint = qPremultiply(colour.rgba());
  const auto step = image_.bytesPerLine() / int(sizeof(QRgb));
  QRgb* const pixels = reinterpret_cast<QRgb*>(image_.bits()) + column;
  const auto at = [&](int row) -> QRgb& { return pixels[std::ptrdiff_t(row) * step]; };
  const int first = int(top), last = std::min(int(bottom), image_.height() - 1);
  if (first == last) return blend(at(first), paint, unsigned(256.0 * (bottom - top)));
  blend(at(first), paint, unsigned(256.0 * (first + 1.0 - top)));
  blend(at(last), paint, unsigned(256.0 * std::min(1.0, bottom - last)));
  if (qAlpha(paint) == 255)
    for (int row = first + 1; row < last; ++row) at(row) = paint;
  else
    for (int row = first + 1; row < last; ++row) blend(at(row), paint, 256U);
}

/// Each column takes what its neighbours cover, so that steep lines are as wide as level ones.
void SpanImage::widen(const std::vector<Range>& spans, int by) {
  wide_ = spans;
  const int size = int(spans.size());
  for (int i = 0; i < size; ++i)
    for (int j = std::max(0, i - by / 2); j <= std::min(size - 1, i + (by - 1) / 2); ++j) {
      wide_[i].low = std::min(wide_[i].low, spans[j].low);
      wide_[i].high = std::max(wide_[i].high, spans[j].high);
    }
}

void SpanImage::line(const std::vector<Range>& spans, const QColor& colour, double width) {
  const double pixels = width * scale_;
  widen(spans, std::max(1, int(std::lround(pixels))));
  const int size = std::min(int(wide_.size()), image_.width());
  for (int i = 0; i < size; ++i) {
    if (wide_[i].low > wide_[i].high) continue;
    double top = row_of(wide_[i].high) - pixels / 2, bottom = row_of(wide_[i].low) + pixels / 2;
    if (pixels < 2.0) {  // a thin line shared by two rows would be pale in both
      const double by = std::round(top) - top;
      top += by;
      bottom += by;
    }
    fill(i, top, bottom, colour);
  }
}

void SpanImage::area(const std::vector<Range>& low, const std::vector<Range>& high,
                     const QColor& colour) {
  const int size = std::min({int(low.size()), int(high.size()), image_.width()});
  for (int i = 0; i < size; ++i)
    if (low[i].low <= low[i].high && high[i].low <= high[i].high)
      fill(i, row_of(high[i].high), row_of(low[i].low), colour);
}

}  // namespace searig::app::desktop
