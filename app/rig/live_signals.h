// What the estimate follows, out of what devices say, while they say it.
#pragma once

#include <array>
#include <vector>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recorder/entry.h"
#include "estimator/signals.h"

namespace searig::app {

class LiveSignals {
 public:
  explicit LiveSignals(double lever_arm_m) : lever_arm_m_(lever_arm_m) {}

  /// Takes the samples among the entries.
  void take(const std::vector<acquisition::Entry>& entries);

  /// Places the load cell on the module's clock anew, with a better map.
  void place(const acquisition::ClockMap& map);

  const estimator::Signals& signals() const { return signals_; }

 private:
  void take(const acquisition::Columns& columns);
  void take(const acquisition::SampleRow& row);

  double lever_arm_m_;
  acquisition::ClockMap map_;
  std::vector<double> loadcell_s_;                                             ///< its own clock
  std::vector<std::pair<std::size_t, std::vector<double>*>> module_channels_;  ///< place in a row
  std::size_t input_ = 0, output_ = 0, force_ = 0;  ///< places in a row; 0 where there is none
  estimator::Signals signals_;
};

}  // namespace searig::app
