// The first time through a recording: all that has to be known before a drive torque is.
#pragma once

#include <cstddef>
#include <vector>

#include "estimator/evaluation/telemetry.h"
#include "estimator/signals.h"

namespace searig::estimator {

/// The module at the load cell's samples. All vectors are as long as loadcell.t_s, or empty where
/// the telemetry has no such channel.
struct Survey {
  std::size_t rows = 0;  ///< of the telemetry
  double first_s = 0, last_s = 0;
  bool has_deflection = false, has_current = false, has_input_motion = false;
  LoadcellSignals loadcell;  ///< those samples that telemetry covers, in order of time
  std::vector<double> deflection_rad, current_a;
  std::vector<double> weights;  ///< trust weights (3), gamma at the size that the module has here
};

enum class Weights { wanted, unwanted };

/// A load-cell sample is covered where it is a number at one of the telemetry's times, or between
/// two that are no further apart than ten usual steps. The load cell's samples come out in order.
Survey survey_of(const Telemetry& telemetry, const LoadcellSignals& loadcell, Weights weights);

}  // namespace searig::estimator
