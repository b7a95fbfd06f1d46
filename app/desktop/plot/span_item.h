// The curves of a plot as one item of Qwt's. The one place where Qwt meets the data.
#pragma once

#include <qwt_plot_item.h>

#include <QColor>
#include <vector>

#include "app/desktop/plot/span_image.h"
#include "app/report/scrolling_spans.h"

namespace searig::app::desktop {

class SpanItem : public QwtPlotItem {
 public:
  enum class Kind { line, dots, band };

  std::size_t add(Kind kind);
  void set_colour(std::size_t curve, const QColor& colour) { curves_[curve].colour = colour; }
  /// The columns stay with their owner, which keeps them alive and may only append between calls;
  /// whatever else changes in them, they are to be set anew. `high` is a band's, else null.
  void set_data(std::size_t curve, const std::vector<double>* x, const std::vector<double>* y,
                const std::vector<double>* high);

  /// Works out what covers so many pixel columns between the middles of the first and the last, or
  /// up to half a column beside: columns that move stay what they are.
  void choose(Range x, std::size_t columns);
  /// Of what was chosen, of all curves or of one; low > high where there is nothing.
  Range y_range() const;
  Range y_range(std::size_t curve) const;

  void draw(QPainter* painter, const QwtScaleMap& x_map, const QwtScaleMap& y_map,
            const QRectF& canvas) const override;

 private:
  struct Side {
    const std::vector<double>* y = nullptr;
    Extremes extremes;
    ScrollingSpans spans;
  };
  struct Curve {
    Kind kind;
    QColor colour;
    const std::vector<double>* x = nullptr;
    Side side, high;
  };

  std::vector<Curve> curves_;
  Range x_;
  std::size_t columns_ = 0;
  mutable SpanImage image_;  // kept for its memory only
};

}  // namespace searig::app::desktop
