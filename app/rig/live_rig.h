// The simulated rig with the estimate running on it, as a view or the demo drives it.
#pragma once

#include "acquisition/clock/synchronise.h"
#include "app/rig/live_estimate.h"
#include "app/rig/simulated_rig.h"

namespace searig::app {

class LiveRig {
 public:
  explicit LiveRig(const RigSettings& settings = {});

  /// Everything up to this host time: samples, clock map, estimate.
  void run_until(double host_s);

  const acquisition::Recording& recording() const { return rig_.recording(); }
  const acquisition::ClockMap& clock() const { return clock_; }
  const History& history() const { return estimate_.history(); }
  const estimator::Model& model() const { return model_; }
  const SimulatedRig& rig() const { return rig_; }

 private:
  void take_module();
  void take_loadcell(double host_s);

  SimulatedRig rig_;
  estimator::Model model_;
  LiveEstimate estimate_;
  estimator::Signals signals_;
  acquisition::ClockMap clock_;
  double synchronised_s_ = -1e9;  ///< host time of the last synchronisation
};

}  // namespace searig::app
