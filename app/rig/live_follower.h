// Entries of a rig -> the columns that a live view draws. No thread, no clock of its own.
#pragma once

#include <deque>
#include <optional>
#include <vector>

#include "acquisition/recorder/device_stream.h"
#include "acquisition/recorder/rolling_clock.h"
#include "app/rig/estimate_stream.h"
#include "app/rig/live_columns.h"
#include "app/rig/live_signals.h"
#include "app/rig/stiffness_interval.h"

namespace searig::app {

struct FollowOptions {
  double lever_arm_m = 1.0;
  std::optional<acquisition::CountsToForce> loadcell;  ///< instead of what it has stored itself
  /// Says what a current is worth; without one torque is measured only.
  std::optional<estimator::Model> model;
};

class LiveFollower {
 public:
  explicit LiveFollower(const FollowOptions& options);

  void take(const std::vector<acquisition::Entry>& entries);
  /// Holds the clocks against each other; costs some ms, so once a second.
  void hold_clocks();
  /// Appends what can be said now.
  void follow(LiveColumns& out);
  /// The newest samples, which have no estimate of their own yet.
  void tail(std::vector<double>& t_s, std::vector<double>& torque_nm) const;

  const std::optional<acquisition::ClockMap>& clock() const { return clock_; }
  /// Newest sample of the module, s since the first.
  double now_s() const;

 private:
  void take_estimate(const estimator::OnlineEstimate& estimate, LiveColumns& out);
  void take_residuals(LiveColumns& out);
  estimator::Regime regime_at(std::size_t sample, double torque_nm);
  void hand_on_loadcell(LiveColumns& out);

  std::optional<EstimateStream> stream_;
  std::optional<StiffnessInterval> interval_;
  LiveSignals signals_;
  acquisition::RollingClock rolling_;
  std::optional<acquisition::ClockMap> clock_;
  std::vector<estimator::OnlineEstimate> fresh_;

  struct Estimated {
    double t_s, torque_nm;
    estimator::Regime regime;
  };
  std::deque<Estimated> lately_;  ///< of the last second: residuals and rates are taken from it
  estimator::RegimeFinder regimes_;
  std::optional<double> start_s_;
  double loadcell_until_s_, residual_until_s_;
};

}  // namespace searig::app
