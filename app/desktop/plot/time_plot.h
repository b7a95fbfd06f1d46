// One plot over time with its caption and legend above, where they cover no data.
#pragma once

#include <QLabel>
#include <QString>
#include <QWidget>
#include <vector>

#include "app/desktop/theme.h"
#include "app/report/plot.h"

class QwtPlot;
class QwtPlotCurve;
class QwtPlotGrid;

namespace searig::app::desktop {

class DecimatedSeries;

class TimePlot : public QWidget {
 public:
  TimePlot(const QString& title, const QString& y_label, QWidget* parent = nullptr);

  void add_curve(const QString& name, Hue hue);
  void rename_curve(std::size_t curve, const QString& name);
  /// The columns belong to the caller, who keeps them alive.
  void set_data(std::size_t curve, const std::vector<double>* x, const std::vector<double>* y);
  /// Keeps the y axis where it is; otherwise it follows the data in view.
  void fix_y(Range range);
  void show_range(Range time_s);
  void set_theme(const Theme& theme);

  /// Where the data are drawn, and what range they are drawn over.
  const QWidget& canvas() const;
  Range x_range() const;
  Range y_range() const;

 private:
  struct Curve {
    QString name;
    Hue hue;
    QwtPlotCurve* curve;      // owned by plot_
    DecimatedSeries* series;  // owned by curve
  };

  void follow_data();
  void write_caption();

  QString title_;
  Theme theme_{false};
  QLabel* caption_;
  QwtPlot* plot_;
  QwtPlotGrid* grid_;  // owned by plot_
  std::vector<Curve> curves_;
  bool y_fixed_ = false;
};

}  // namespace searig::app::desktop
