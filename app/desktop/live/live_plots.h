// The four plots of a running rig over one time axis, and the minutes that they show.
#pragma once

#include <QWidget>
#include <array>
#include <optional>
#include <vector>

#include "app/desktop/theme.h"
#include "app/report/plot.h"
#include "app/rig/live_feed.h"
#include "estimator/model/planned_motion.h"

namespace searig::app::desktop {

class TimePlot;

class LivePlots : public QWidget {
 public:
  explicit LivePlots(QWidget* parent = nullptr);

  /// Takes up what came; what is shown moves on unless it is paused.
  void take(LiveNews& news);
  void draw();
  void clear();

  /// The view stays, the data go on and are kept for an hour instead of ten minutes.
  void pause(bool on);
  bool paused() const { return paused_; }
  void zoom(double factor);
  void move(double share);  ///< while paused
  void show_all();
  void mark(const std::string& words);
  /// Shows a motion to follow, beside how the module moves: it begins after a countdown.
  void lead(const estimator::PlannedMotion& motion);
  void stop_leading();
  bool leading() const { return lead_from_s_.has_value(); }
  void set_theme(const Theme& theme);

  const LiveColumns& columns() const { return columns_; }
  double now_s() const { return now_s_; }

 private:
  void make_plots();
  void connect_columns();
  void show_marks();
  void make_target();
  void connect_target();
  void draw_target();
  void make_room(bool for_target);
  std::vector<TimePlot*> plots() const { return {torque_, residual_, weight_, stiffness_}; }

  LiveColumns columns_;
  std::vector<double> tail_t_s_, tail_nm_;
  std::vector<Mark> marks_;
  double now_s_ = 0.0, span_s_ = 20.0;
  bool paused_ = false;
  Range range_{0.0, 20.0};
  std::optional<double> lead_from_s_;  ///< on the plots' time axis
  double lead_s_ = 0.0;                ///< how long
  estimator::ModuleSignals target_;    ///< likewise
  TimePlot *target_plot_, *torque_, *residual_, *weight_, *stiffness_;
};

}  // namespace searig::app::desktop
