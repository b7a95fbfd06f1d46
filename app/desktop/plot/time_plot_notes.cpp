// What stands in and above a plot beside its data: marks, shading, the legend.
#include <qwt_plot.h>
#include <qwt_plot_marker.h>
#include <qwt_plot_zoneitem.h>

#include <QLabel>
#include <QPen>

#include "app/desktop/plot/small_text.h"
#include "app/desktop/plot/time_plot.h"

namespace searig::app::desktop {
namespace {

constexpr double shade_opacity = 0.22;

/// A colour as it looks over the ground.
QString over(const QColor& colour, const QColor& under, double opacity) {
  const auto mix = [opacity](int a, int b) { return int(opacity * a + (1.0 - opacity) * b); };
  return QColor(mix(colour.red(), under.red()), mix(colour.green(), under.green()),
                mix(colour.blue(), under.blue()))
      .name();
}

}  // namespace

void TimePlot::set_marks(const std::vector<Mark>& marks) {
  for (auto* mark : marks_) delete mark;  // which detaches it
  marks_.clear();
  mark_data_ = marks;
  for (const Mark& mark : marks) {
    auto* line = new QwtPlotMarker;
    line->setLineStyle(QwtPlotMarker::VLine);
    line->setLinePen(theme_.colour(mark.hue), 1.0, Qt::DashLine);
    line->setXValue(mark.x);
    QwtText text = small_text(QString::fromStdString(mark.text));
    text.setColor(theme_.colour(mark.hue));
    line->setLabel(text);
    line->setLabelAlignment(Qt::AlignRight | Qt::AlignTop);
    line->attach(plot_);
    marks_.push_back(line);
  }
}

void TimePlot::set_shaded(const std::vector<Interval>& intervals, const QString& name) {
  for (auto* zone : shaded_) delete zone;  // which detaches it
  shaded_.clear();
  shaded_data_ = intervals;
  for (const Interval& interval : intervals) {
    auto* zone = new QwtPlotZoneItem;
    zone->setOrientation(Qt::Vertical);
    zone->setInterval(interval.from, interval.to);
    zone->setPen(QPen(Qt::NoPen));
    QColor colour = theme_.colour(interval.hue);
    colour.setAlphaF(shade_opacity);
    zone->setBrush(colour);
    zone->setZ(-10.0);  // behind the curves
    zone->attach(plot_);
    shaded_.push_back(zone);
  }
  shading_ = {intervals.empty() ? QString() : name,
              intervals.empty() ? Hue::orange : intervals.front().hue, QStringLiteral("&#x25a0;"),
              shade_opacity};
  write_caption();
}

void TimePlot::rename_curve(std::size_t place, const QString& name) {
  legend_[place].name = name;
  write_caption();
}

void TimePlot::write_caption() {
  QString text = QStringLiteral("<b>%1</b>").arg(title_.toHtmlEscaped());
  std::vector<Entry> entries(legend_.rbegin(), legend_.rend());  // what is above first
  entries.push_back(shading_);
  for (const Entry& entry : entries) {
    if (entry.name.isEmpty()) continue;
    text += QStringLiteral("&nbsp;&nbsp;&nbsp; <span style='color:%1'><b>%2</b></span> %3")
                .arg(over(theme_.colour(entry.hue), theme_.colour(ground), entry.opacity),
                     entry.sign, entry.name.toHtmlEscaped());
  }
  caption_->setText(text);
}

}  // namespace searig::app::desktop
