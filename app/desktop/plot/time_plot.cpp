#include "app/desktop/plot/time_plot.h"

#include <qwt_plot.h>
#include <qwt_plot_canvas.h>
#include <qwt_plot_grid.h>
#include <qwt_plot_layout.h>
#include <qwt_scale_draw.h>
#include <qwt_scale_widget.h>

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/desktop/plot/small_text.h"
#include "app/desktop/plot/span_item.h"

namespace searig::app::desktop {
namespace {

constexpr int axis_width_px = 46;  // the same in every plot, so that their time axes line up

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
      y_label_(y_label),
      caption_(new QLabel(this)),
      plot_(new QwtPlot(this)),
      grid_(new QwtPlotGrid),
      curves_(new SpanItem) {
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(2);
  layout->addWidget(caption_);
  layout->addWidget(plot_, 1);
  caption_->setTextFormat(Qt::RichText);

  plot_->setAxisScale(QwtPlot::yLeft, 0.0, 1.0);  // until there is something to show
  style_axis(*plot_, QwtPlot::yLeft, y_label);
  style_axis(*plot_, QwtPlot::xBottom, QStringLiteral("time (s)"));
  plot_->axisScaleDraw(QwtPlot::yLeft)->setMinimumExtent(axis_width_px);
  plot_->setAxisMaxMajor(QwtPlot::yLeft, 5);
  plot_->setAxisMaxMajor(QwtPlot::xBottom, 12);
  plot_->plotLayout()->setAlignCanvasToScales(true);
  plot_->plotLayout()->setCanvasMargin(0);
  plot_->setMinimumHeight(110);
  auto* canvas = static_cast<QwtPlotCanvas*>(plot_->canvas());
  canvas->setFrameStyle(QFrame::NoFrame);
  // Each frame is another: a copy kept of the last one would only cost.
  canvas->setPaintAttribute(QwtPlotCanvas::BackingStore, false);
  canvas->setPaintAttribute(QwtPlotCanvas::Opaque, true);
  setAutoFillBackground(true);
  setBackgroundRole(QPalette::Base);
  grid_->setZ(-5.0);  // below the curves
  grid_->attach(plot_);
  curves_->setZ(grid_->z() + 1.0);
  curves_->attach(plot_);
  show_time_axis(true);
}

const QWidget& TimePlot::canvas() const {
  return *plot_->canvas();
}

QWidget& TimePlot::canvas() {
  return *plot_->canvas();
}

Plot TimePlot::as_plot() const {
  Plot plot;
  plot.title = title_.toStdString();
  plot.x_label = "time (s)", plot.y_label = y_label_.toStdString();
  plot.marks = mark_data_;
  plot.shaded_name = shading_.name.toStdString();
  plot.x_range = x_range(), plot.y_range = y_range();
  plot.shaded = shaded_data_;
  for (const Entry& entry : legend_) {
    if (!entry.x || !entry.y || entry.x->empty()) continue;
    const auto& x = *entry.x;
    const auto begin = std::lower_bound(x.begin(), x.end(), plot.x_range->low);
    const auto end = std::upper_bound(begin, x.end(), plot.x_range->high);
    const auto first = std::max<std::ptrdiff_t>(0, begin - x.begin() - 1);
    const auto last = std::min<std::ptrdiff_t>(std::ptrdiff_t(x.size()), end - x.begin() + 1);
    const auto part = [&](const std::vector<double>& column) {
      return std::vector<double>(column.begin() + first, column.begin() + last);
    };
    Series series{entry.name.toStdString(), part(x), part(*entry.y), entry.style, entry.hue};
    if (entry.high) series.y_high = part(*entry.high);
    plot.series.push_back(std::move(series));
  }
  return plot;
}

std::size_t TimePlot::add(const QString& name, Hue hue, const QString& sign, double opacity,
                          Style style) {
  legend_.push_back({name, hue, sign, opacity, style});
  return legend_.size() - 1;
}

std::size_t TimePlot::add_curve(const QString& name, Hue hue) {
  curves_->add(SpanItem::Kind::line);
  return add(name, hue, QStringLiteral("&#x2501;&#x2501;"), 1.0, Style::line);
}

std::size_t TimePlot::add_dots(const QString& name, Hue hue) {
  curves_->add(SpanItem::Kind::dots);
  return add(name, hue, QStringLiteral("&#x25cf;"), 1.0, Style::dots);
}

std::size_t TimePlot::add_band(const QString& name, Hue hue, double opacity) {
  curves_->add(SpanItem::Kind::band);
  return add(name, hue, QStringLiteral("&#x25a0;"), opacity, Style::band);
}

void TimePlot::set_data(std::size_t place, const std::vector<double>* x,
                        const std::vector<double>* y) {
  legend_[place].x = x;
  legend_[place].y = y;
  curves_->set_data(place, x, y, nullptr);
}

void TimePlot::set_band(std::size_t place, const std::vector<double>* x,
                        const std::vector<double>* low, const std::vector<double>* high) {
  legend_[place].x = x;
  legend_[place].y = low;
  legend_[place].high = high;
  curves_->set_data(place, x, low, high);
}

void TimePlot::set_theme(const Theme& theme) {
  theme_ = theme;
  for (std::size_t i = 0; i < legend_.size(); ++i) {
    QColor colour = theme.colour(legend_[i].hue);
    colour.setAlphaF(legend_[i].opacity);
    curves_->set_colour(i, colour);
  }
  grid_->setMajorPen(theme.colour(grid), 1.0);
  plot_->setCanvasBackground(theme.colour(ground));
  write_caption();
}

}  // namespace searig::app::desktop
