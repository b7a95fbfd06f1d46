// What the estimate follows, out of what devices say, while they say it.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recorder/entry.h"
#include "estimator/signals.h"

namespace searig::app {

/// Where a device began anew its time goes on as the host's does, so that what is live has one time
/// axis; in a recording each start keeps its own. A datagram that comes late is left out.
class LiveSignals {
 public:
  explicit LiveSignals(double lever_arm_m) : lever_arm_m_(lever_arm_m) {}

  /// Takes the samples among the entries.
  void take(const std::vector<acquisition::Entry>& entries);

  /// Places the load cell on the module's clock anew, with a better map.
  void place(const acquisition::ClockMap& map);

  /// Lets go of all but the last of it; how many samples of the module went.
  std::size_t keep_last(double seconds);

  const estimator::Signals& signals() const { return signals_; }

 private:
  void take(const acquisition::Columns& columns);
  void take(const acquisition::SampleRow& row);
  void take_module(const acquisition::SampleRow& row);
  void take_loadcell(const acquisition::SampleRow& row);
  std::vector<std::vector<double>*> module_columns();

  double lever_arm_m_;
  acquisition::ClockMap map_;
  bool has_map_ = false;
  std::vector<double> loadcell_s_;  ///< its own clock, of the start that map_ is about
  struct Start {                    ///< of the module
    double run = 0.0;
    double shift_s = 0.0;  ///< what its clock is to be given, so that time goes on
    double last_host_s = 0.0;
  };
  Start start_;
  double loadcell_run_ = 0.0;
  std::vector<std::pair<std::size_t, std::vector<double>*>> module_channels_;  ///< place in a row
  std::size_t input_ = 0, output_ = 0, force_ = 0;  ///< places in a row; 0 where there is none
  bool computes_deflection_ = false;                ///< the module tells its angles alone
  estimator::Signals signals_;
};

}  // namespace searig::app
