// The four plots of a running rig over one time axis, and the minutes that they show.
#pragma once

#include <QWidget>
#include <array>
#include <vector>

#include "app/desktop/theme.h"
#include "app/report/plot.h"
#include "app/rig/live_feed.h"

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
  void set_theme(const Theme& theme);

  const LiveColumns& columns() const { return columns_; }
  double now_s() const { return now_s_; }

 private:
  void make_plots();
  void connect_columns();
  void show_marks();
  std::vector<TimePlot*> plots() const { return {torque_, residual_, weight_, stiffness_}; }

  LiveColumns columns_;
  std::vector<double> tail_t_s_, tail_nm_;
  std::vector<Mark> marks_;
  double now_s_ = 0.0, span_s_ = 20.0;
  bool paused_ = false;
  Range range_{0.0, 20.0};
  TimePlot *torque_, *residual_, *weight_, *stiffness_;
};

}  // namespace searig::app::desktop
