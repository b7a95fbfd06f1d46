// The next experiment as a motion to follow: what to do, the target, and where it is now.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <utility>

#include "app/desktop/theme.h"
#include "estimator/model/planned_motion.h"

class QLabel;
class QPushButton;

namespace searig::app::desktop {

class TimePlot;

class GuidedMotion : public QWidget {
 public:
  explicit GuidedMotion(QWidget* parent);

  void show_motion(const estimator::PlannedMotion& motion, const QString& why);
  /// Starts or stops. Whoever leads better (with the rig in view) does it instead, by true.
  void toggle();
  void on_start(std::function<bool(const estimator::PlannedMotion&)> lead) {
    lead_ = std::move(lead);
  }
  /// Counts down, then leads through the motion.
  void start();
  void stop();
  bool running() const { return timer_.isActive(); }
  /// What is to be followed `t_s` after the countdown began; for tests too.
  void show_time(double t_s);
  void on_close(std::function<void()> close);
  void on_save(std::function<void()> save);
  void set_theme(const Theme& theme);

 private:
  void say_target(double t_s);

  std::function<bool(const estimator::PlannedMotion&)> lead_;
  estimator::PlannedMotion motion_;
  estimator::ModuleSignals target_;
  QElapsedTimer since_start_;
  QTimer timer_;
  QLabel* title_;
  QLabel* steps_;
  QLabel* now_;
  TimePlot* plot_;
  QPushButton* start_;
  QPushButton* save_;
  QPushButton* close_;
};

}  // namespace searig::app::desktop
