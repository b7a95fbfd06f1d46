#include "app/desktop/plot/time_plot.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_curve.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

#include <QVBoxLayout>
#include <algorithm>

#include "app/desktop/plot/decimated_series.h"

namespace searig::app::desktop {
namespace {

constexpr int axis_width_px = 46;  // the same in every plot, so that their time axes line up

QwtText small_text(const QString& words) {
  QwtText text(words);
  QFont font = text.font();
  font.setPointSizeF(9.0);
  font.setBold(false);
  text.setFont(font);
  return text;
}

void style_axis(QwtPlot& plot, int axis, const QString& label) {
  plot.setAxisTitle(axis, small_text(label));
  QFont font = plot.axisFont(axis);
  font.setPointSizeF(9.0);
  plot.setAxisFont(axis, font);
  plot.axisScaleDraw(axis)->enableComponent(QwtAbstractScaleDraw::Backbone, false);
  plot.axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MinorTick, 0);
  plot.axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MediumTick, 0);
  plot.axisScaleDraw(axis)->setTickLength(QwtScaleDiv::MajorTick, 4);
  plot.axisWidget(axis)->setMargin(0);
}

}  // namespace

TimePlot::TimePlot(const QString& title, const QString& y_label, QWidget* parent)
    : QWidget(parent),
      title_(title),
      caption_(new QLabel(this)),
      plot_(new QwtPlot(this)),
      grid_(new QwtPlotGrid) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 12, 2);
  layout->setSpacing(2);
  layout->addWidget(caption_);
  layout->addWidget(plot_, 1);
  caption_->setTextFormat(Qt::RichText);

  style_axis(*plot_, QwtPlot::yLeft, y_label);
  style_axis(*plot_, QwtPlot::xBottom, QStringLiteral("time (s)"));
  plot_->axisScaleDraw(QwtPlot::yLeft)->setMinimumExtent(axis_width_px);
  plot_->setAxisMaxMajor(QwtPlot::yLeft, 5);
  plot_->setAxisMaxMajor(QwtPlot::xBottom, 12);
  plot_->plotLayout()->setAlignCanvasToScales(true);
  plot_->plotLayout()->setCanvasMargin(0);
  plot_->setMinimumHeight(110);
  static_cast<QwtPlotCanvas*>(plot_->canvas())->setFrameStyle(QFrame::NoFrame);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  grid_->attach(plot_);
}

const QWidget& TimePlot::canvas() const {
  return *plot_->canvas();
}

Range TimePlot::x_range() const {
  const auto interval = plot_->axisInterval(QwtPlot::xBottom);
  return {interval.minValue(), interval.maxValue()};
}

Range TimePlot::y_range() const {
  const auto interval = plot_->axisInterval(QwtPlot::yLeft);
  return {interval.minValue(), interval.maxValue()};
}

void TimePlot::add_curve(const QString& name, Hue hue) {
  auto* curve = new QwtPlotCurve(name);
  auto* series = new DecimatedSeries;
  curve->setSamples(series);
  curve->setRenderHint(QwtPlotItem::RenderAntialiased, false);  // slow on dense curves
  curve->attach(plot_);
  curves_.push_back({name, hue, curve, series});
}

void TimePlot::set_data(std::size_t curve, const std::vector<double>* x,
                        const std::vector<double>* y) {
  curves_[curve].series->show(x, y);
}

void TimePlot::fix_y(Range range) {
  y_fixed_ = true;
  plot_->setAxisScale(QwtPlot::yLeft, range.low, range.high);
}

void TimePlot::show_range(Range time_s) {
  plot_->setAxisScale(QwtPlot::xBottom, time_s.low, time_s.high);
  for (auto& curve : curves_) {
    curve.series->choose(time_s.low, time_s.high, plot_->canvas()->width());
  }
  if (!y_fixed_) follow_data();
  plot_->replot();
}

void TimePlot::follow_data() {
  QRectF all;
  for (const auto& curve : curves_) {
    if (curve.series->size() > 0) all |= curve.series->boundingRect();
  }
  if (all.height() <= 0.0) return;
  const double margin = 0.06 * all.height();
  plot_->setAxisScale(QwtPlot::yLeft, all.top() - margin, all.bottom() + margin);
}

void TimePlot::set_theme(const Theme& theme) {
  theme_ = theme;
  for (auto& curve : curves_) curve.curve->setPen(theme.colour(curve.hue), 1.0);
  grid_->setMajorPen(theme.colour(grid), 1.0);
  plot_->setCanvasBackground(theme.colour(ground));
  write_caption();
}

void TimePlot::rename_curve(std::size_t curve, const QString& name) {
  curves_[curve].name = name;
  write_caption();
}

void TimePlot::write_caption() {
  QString text = QStringLiteral("<b>%1</b>").arg(title_.toHtmlEscaped());
  for (const auto& curve : curves_) {
    text += QStringLiteral(
                "&nbsp;&nbsp;&nbsp;&nbsp;<span style='color:%1'><b>&#x2501;&#x2501;</b></span> %2")
                .arg(theme_.colour(curve.hue).name(), curve.name.toHtmlEscaped());
  }
  caption_->setText(text);
}

}  // namespace searig::app::desktop
