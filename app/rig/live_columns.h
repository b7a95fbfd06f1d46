// What a live view draws, ready for its plots: the last minutes of an experiment.
#pragma once

#include <array>
#include <vector>

#include "estimator/evaluation/regime.h"

namespace searig::app {

/// Times are seconds since the first telemetry, on the module's clock.
struct LiveColumns {
  /// Each in step with t_s; low and high are ends of intervals.
  std::vector<double> t_s;
  std::vector<double> torque_nm;                    ///< k*theta with the k of that moment
  std::vector<double> low_nm, high_nm;              ///< 95 % for the stiffness (StiffnessInterval)
  std::vector<double> clock_low_nm, clock_high_nm;  ///< that and what the clocks' interval adds
  std::vector<double> weight;                       ///< trust in the motor current, 0..1
  std::vector<double> k_nm_per_rad, k_low_nm_per_rad, k_high_nm_per_rad;

  std::vector<double> deflection_rad, output_angle_rad;  ///< NaN where it is not told

  std::vector<double> loadcell_t_s, loadcell_nm;

  struct Residuals {
    std::vector<double> t_s, nm;  ///< measured minus estimated
  };
  std::array<Residuals, estimator::regime_names.size()> residuals;

  /// Joins what follows.
  void append(const LiveColumns& later);
  /// Lets go of what is older; true where something was. Then all columns begin elsewhere.
  bool forget_before(double t);

  /// mean |measured - estimated| over mean |measured| from `from_s` on, in percent; NaN where
  /// nothing can be compared.
  double error_percent(double from_s) const;
};

}  // namespace searig::app
