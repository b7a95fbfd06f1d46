// One plot over time with its caption and legend above, where they cover no data.
#pragma once

#include <QString>
#include <QWidget>
#include <cstddef>
#include <optional>
#include <vector>

#include "app/desktop/theme.h"
#include "app/report/plot.h"

class QLabel;
class QwtPlot;
class QwtPlotGrid;
class QwtPlotMarker;
class QwtPlotZoneItem;

namespace searig::app::desktop {

class SpanItem;

/// What is added later is drawn above. The columns that are set belong to the caller, who keeps
/// them alive and may append to them; whatever else changes in them, they are to be set anew. Their
/// number costs nothing: a frame takes the same time for a thousand points as for a million.
class TimePlot : public QWidget {
 public:
  TimePlot(const QString& title, const QString& y_label, QWidget* parent = nullptr);

  /// Each returns the place by which it is spoken of.
  std::size_t add_curve(const QString& name, Hue hue);
  std::size_t add_dots(const QString& name, Hue hue);
  std::size_t add_band(const QString& name, Hue hue, double opacity);
  void rename_curve(std::size_t place, const QString& name);
  void set_data(std::size_t place, const std::vector<double>* x, const std::vector<double>* y);
  void set_band(std::size_t place, const std::vector<double>* x, const std::vector<double>* low,
                const std::vector<double>* high);
  /// Vertical lines with a word each.
  void set_marks(const std::vector<Mark>& marks);
  /// Stretches of time behind the curves; `name` is what they mean, for the legend.
  void set_shaded(const std::vector<Interval>& intervals, const QString& name);

  /// Keeps the y axis where it is; otherwise it follows the data in view.
  void fix_y(Range range);
  /// It follows one curve alone, with room about it, wherever that has data in view: what runs far
  /// away from it flattens nothing.
  void follow_y(std::size_t place) { followed_ = place; }
  /// It has `value` in the middle and half of it to either side at the furthest, so that a first
  /// guess ten times too high flattens nothing; at the nearest a twentieth, so that noise stays
  /// noise.
  void follow_y_about(double value) { about_ = value; }
  void show_range(Range time_s);
  /// Of plots below each other the lowest alone may have it.
  void show_time_axis(bool shown);
  void set_theme(const Theme& theme);

  /// Where the data are drawn, and what range they are drawn over.
  const QWidget& canvas() const;
  QWidget& canvas();
  /// Of a point on the canvas, by its logical pixel from the left.
  double time_at(int x_px) const;
  Range x_range() const;
  Range y_range() const;
  /// What is in view, for other pictures; data outside are left out, but for a point at each end.
  Plot as_plot() const;

 private:
  struct Entry {
    QString name;
    Hue hue;
    QString sign;  ///< before the name in the legend
    double opacity;
    Style style = Style::line;
    const std::vector<double>* x = nullptr;
    const std::vector<double>* y = nullptr;
    const std::vector<double>* high = nullptr;
  };

  std::size_t add(const QString& name, Hue hue, const QString& sign, double opacity, Style style);
  Range in_view() const;
  void follow_data();
  void write_caption();

  QString title_, y_label_;
  Theme theme_{false};
  QLabel* caption_;
  QwtPlot* plot_;
  QwtPlotGrid* grid_;  // owned by plot_, as the items below
  SpanItem* curves_;
  std::vector<QwtPlotMarker*> marks_;
  std::vector<QwtPlotZoneItem*> shaded_;
  std::vector<Mark> mark_data_;
  std::vector<Interval> shaded_data_;
  Entry shading_{{}, Hue::orange, {}, 0.0};
  std::vector<Entry> legend_;
  bool y_fixed_ = false;
  std::optional<std::size_t> followed_;
  double about_ = 0.0;  // 0: wherever the data are
};

}  // namespace searig::app::desktop
