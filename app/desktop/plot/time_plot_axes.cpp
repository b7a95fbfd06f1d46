// TimePlot's axes: what they show, and how they follow the data.
#include <qwt_plot.h>
#include <qwt_scale_widget.h>

#include <QLayout>
#include <algorithm>
#include <cmath>

#include "app/desktop/plot/span_item.h"
#include "app/desktop/plot/time_plot.h"

namespace searig::app::desktop {
namespace {

constexpr int half_label_px = 24;

}  // namespace

double TimePlot::time_at(int x_px) const {
  const Range shown = x_range();
  return shown.low + (shown.high - shown.low) * x_px / std::max(1, canvas().width() - 1);
}

Range TimePlot::x_range() const {
  const auto interval = plot_->axisInterval(QwtPlot::xBottom);
  return {interval.minValue(), interval.maxValue()};
}

Range TimePlot::y_range() const {
  const auto interval = plot_->axisInterval(QwtPlot::yLeft);
  return {interval.minValue(), interval.maxValue()};
}

void TimePlot::fix_y(Range range) {
  y_fixed_ = true;
  plot_->setAxisScale(QwtPlot::yLeft, range.low, range.high);
}

/// With or without, the canvas ends at the same place: half a label before the right edge.
void TimePlot::show_time_axis(bool shown) {
  plot_->enableAxis(QwtPlot::xBottom, shown);
  plot_->axisWidget(QwtPlot::xBottom)->setMinBorderDist(0, half_label_px);
  layout()->setContentsMargins(8, 6, shown ? 4 : 4 + half_label_px, 2);
}

void TimePlot::show_range(Range time_s) {
  plot_->setAxisScale(QwtPlot::xBottom, time_s.low, time_s.high);
  const QWidget& canvas = *plot_->canvas();
  curves_->choose(time_s, std::size_t(std::lround(canvas.width() * canvas.devicePixelRatioF())));
  if (!y_fixed_) follow_data();
  plot_->replot();
}

/// Of the data in view, what the axis is to show.
Range TimePlot::in_view() const {
  Range seen = curves_->y_range();
  if (followed_) {
    const Range one = curves_->y_range(*followed_);
    const double room = 0.4 * (one.high - one.low);
    if (room > 0.0)
      seen = {std::max(seen.low, one.low - room), std::min(seen.high, one.high + room)};
  }
  if (about_ > 0.0 && seen.high >= seen.low) {
    const double furthest = std::max(seen.high - about_, about_ - seen.low);
    const double half = std::clamp(furthest, 0.05 * about_, 0.5 * about_);
    seen = {about_ - half, about_ + half};
  }
  return seen;
}

/// The axis stands still as long as the data fill it well: one that moves all the time can be
/// neither read nor drawn cheaply.
void TimePlot::follow_data() {
  const Range seen = in_view();
  if (!(seen.high >= seen.low)) return;
  const double height = std::max({seen.high - seen.low, 1e-9 * std::abs(seen.high), 1e-12});
  const Range now = y_range();
  const bool holds = now.low <= seen.low && now.high >= seen.high;
  if (holds && height > 0.6 * (now.high - now.low)) return;
  plot_->setAxisScale(QwtPlot::yLeft, seen.low - 0.1 * height, seen.high + 0.1 * height);
}

}  // namespace searig::app::desktop
