// The simulated rig as the host sees it: two streams of stamped samples, as from real devices.
#pragma once

#include <cstdint>
#include <deque>
#include <vector>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/recording.h"
#include "app/rig/link.h"
#include "estimator/twin/twin.h"

namespace searig::app {

struct RigSettings {
  estimator::twin::Parameters parameters;
  std::uint64_t seed = 1;
  /// Telemetry over Ethernet; the module's crystal is good.
  LinkSettings module{{14.0, 437.5}, 500.0, 0.0004, 0.0002, 0.0, 1e-6};
  /// An Arduino with a ceramic resonator behind a USB serial line that loses a frame now and then.
  LinkSettings loadcell{{-310.0, 62.25}, 50.0, 0.0015, 0.0008, 0.001, 4e-6};
};

class SimulatedRig {
 public:
  explicit SimulatedRig(const RigSettings& settings = {});

  /// Appends to recording() all samples that arrive up to this host time. The result does not
  /// depend on how the time is cut into calls.
  void run_until(double host_s);

  const acquisition::Recording& recording() const { return recording_; }
  /// What synchronise() should find: module time from load-cell time.
  acquisition::ClockMap true_clock_map() const;
  double true_stiffness_nm_per_rad() const { return twin_.stiffness_nm_per_rad(); }
  const RigSettings& settings() const { return settings_; }

 private:
  /// A sample that was taken and is on its way.
  struct Sample {
    Link::Passage passage;
    std::vector<double> values;  ///< in the order of the stream's channels
  };

  void take_module_sample();
  void take_loadcell_sample();
  static void deliver(std::deque<Sample>& on_the_way, double host_s, acquisition::Stream& stream);

  RigSettings settings_;
  estimator::twin::Twin twin_;
  Link module_link_;
  Link loadcell_link_;
  std::deque<Sample> module_on_the_way_;
  std::deque<Sample> loadcell_on_the_way_;
  acquisition::Recording recording_;
};

}  // namespace searig::app
