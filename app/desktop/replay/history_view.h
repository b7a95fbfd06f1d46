// An experiment in three plots over one time axis, with the numbers that matter above: two runs of
// the estimator over each other, and two cursors.
#pragma once

#include <QHBoxLayout>
#include <QWidget>
#include <functional>
#include <optional>
#include <vector>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/recording.h"
#include "app/desktop/theme.h"
#include "app/report/plot.h"
#include "app/rig/history.h"
#include "app/session/regime_residuals.h"

class QLabel;
class QScrollBar;

namespace searig::app::desktop {

class Readouts;
class TimePlot;

/// Times that are marked; nothing where there is no cursor.
struct Cursors {
  std::optional<double> a_s, b_s;
};

class HistoryView : public QWidget {
 public:
  explicit HistoryView(QWidget* parent = nullptr);

  /// On the right of the plots.
  void put_beside(QWidget* side) { row_->addWidget(side); }
  /// Histories belong to the caller, who keeps them alive until others are shown. Plots of what
  /// none of them has are hidden. `second` may be null.
  void show_histories(const History* first, const History* second);
  /// What was measured less the first of them, by regime; until others are shown.
  void show_residuals(RegimeResiduals residuals);
  /// Stretches of time in which a diagnosis found the model wanting.
  void shade(const std::vector<Interval>& intervals, const QString& name);
  void show_numbers(const acquisition::Recording& recording, const acquisition::ClockMap& clock);
  /// What to do next, or what went wrong; empty takes it away.
  void say(const QString& words);
  QString said() const;

  Range range() const { return range_; }
  void show_range(Range time_s);
  void zoom(double factor);
  void zoom_at(double factor, double at_s);
  void zoom_to(Range time_s);  ///< and back() leads where it was
  void back();
  void move(double share);  ///< by this share of what is shown
  void show_all();

  const Cursors& cursors() const { return cursors_; }
  void set_cursors(const Cursors& cursors);
  void on_cursors(std::function<void()> moved) { cursors_moved_ = std::move(moved); }
  void set_theme(const Theme& theme);
  std::vector<TimePlot*> plots() const { return {torque_, residual_, weight_, stiffness_}; }

 private:
  void make_plots();
  void watch_mouse();
  void scroll_to(int value);
  void place_scroll_bar();
  double end_s() const;

  const History* first_ = nullptr;
  const History* second_ = nullptr;
  Range range_{0.0, 20.0};
  std::vector<Range> before_;  ///< where back() leads
  Cursors cursors_;
  std::function<void()> cursors_moved_;
  Readouts* readouts_;
  RegimeResiduals residuals_;
  std::vector<Interval> shaded_;
  QString shaded_name_;
  TimePlot* torque_;
  TimePlot* residual_;
  TimePlot* weight_;
  TimePlot* stiffness_;
  QLabel* hint_;
  QLabel* status_;  ///< of the clocks and streams
  QScrollBar* scrub_;
  QHBoxLayout* row_;
};

}  // namespace searig::app::desktop
