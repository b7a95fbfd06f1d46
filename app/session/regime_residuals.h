// What was measured less what was estimated, by what the drive train does meanwhile.
#pragma once

#include <cstddef>

#include "app/rig/live_columns.h"
#include "estimator/evaluation/regime.h"
#include "estimator/signals.h"

namespace searig::app {

using RegimeResiduals = decltype(LiveColumns::residuals);

/// Goes along with an estimate, sample by sample, and has a residual for each reading of the load
/// cell that lies between two of them. Where no input moves, all is sticking.
class ResidualFinder {
 public:
  /// The signals must outlive it.
  explicit ResidualFinder(const estimator::Signals& signals) : signals_(signals) {}

  /// The estimated torque at t_s, on the module's clock. Times rise.
  void push(double t_s, double torque_nm);

  /// Times are seconds since the first telemetry.
  RegimeResiduals finish() { return std::move(found_); }

 private:
  double velocity() const;

  const estimator::Signals& signals_;
  estimator::RegimeFinder regimes_;
  RegimeResiduals found_;
  std::size_t row_ = 0, row_before_ = 0;  ///< of the module: at the estimate, and a little earlier
  std::size_t reading_ = 0;               ///< the first of the load cell that is still to come
  double before_s_ = 0.0, before_nm_ = 0.0;
  bool any_ = false;
};

}  // namespace searig::app
