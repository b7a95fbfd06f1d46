// Lines and areas as pixels, column by column: what QPainter takes ten times as long for.
#pragma once

#include <QColor>
#include <QImage>
#include <vector>

#include "app/report/plot.h"

namespace searig::app::desktop {

/// An image over a plot's canvas, transparent where nothing is drawn. One column of spans for each
/// of its pixel columns.
class SpanImage {
 public:
  /// y: what the image shows from its lower to its upper edge. scale: pixels in a logical one.
  void begin(QSize pixels, Range y, double scale);

  /// The covered ranges of a line, made as thick as a pen of so many logical pixels.
  void line(const std::vector<Range>& spans, const QColor& colour, double width);
  /// From the lowest of one line to the highest of the other.
  void area(const std::vector<Range>& low, const std::vector<Range>& high, const QColor& colour);

  const QImage& image() const { return image_; }

 private:
  void fill(int column, double top, double bottom, const QColor& colour);
  void widen(const std::vector<Range>& spans, int by);
  double row_of(double y) const { return (y_.high - y) * rows_per_y_; }

  QImage image_;
  Range y_;
  double rows_per_y_ = 1.0, scale_ = 1.0;
  std::vector<Range> wide_;  // kept for its memory only
};

}  // namespace searig::app::desktop
