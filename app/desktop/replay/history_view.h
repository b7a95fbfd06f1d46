// An experiment in three plots over one time axis, with the numbers that matter above.
#pragma once

#include <QWidget>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/recording.h"
#include "app/desktop/theme.h"
#include "app/report/plot.h"
#include "app/rig/history.h"

class QLabel;
class QVBoxLayout;

namespace searig::app::desktop {

class Readouts;
class TimePlot;

class HistoryView : public QWidget {
 public:
  explicit HistoryView(QWidget* parent = nullptr);

  /// The history belongs to the caller, who keeps it alive and may append to it. Without an online
  /// estimate only torques are shown.
  void show_history(const History* history, bool online);
  void show_numbers(const acquisition::Recording& recording, const acquisition::ClockMap& clock,
                    bool live);
  /// What to do next, or what went wrong; empty takes it away.
  void say(const QString& words);
  QString said() const;

  Range range() const { return range_; }
  void show_range(Range time_s);
  void zoom(double factor);
  void move(double share);  ///< by this share of what is shown
  void show_all();
  void set_theme(const Theme& theme);

 private:
  void make_plots();

  const History* history_ = nullptr;
  Range range_{0.0, 20.0};
  Readouts* readouts_;
  TimePlot* torque_;
  TimePlot* weight_;
  TimePlot* stiffness_;
  QLabel* hint_;
  QLabel* status_;  ///< of the clocks and streams
};

}  // namespace searig::app::desktop
