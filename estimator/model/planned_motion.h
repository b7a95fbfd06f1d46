// A motion for a rig or a simulation to follow, in a few numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "estimator/signals.h"

namespace searig::estimator {

/// The deflection follows `kind`; the lever swings beside it, or is locked. As many parts as the
/// longer list has entries, one after the other, each as long; the shorter list repeats.
struct PlannedMotion {
  enum class Kind { triangle, sine, multisine, staircase, hold };

  Kind kind = Kind::multisine;
  double seconds = 60.0;
  std::vector<double> amplitudes_rad{0.2};  ///< of the deflection
  std::vector<double> frequencies_hz{0.5};  ///< highest of a multisine, steps per second of steps
  double output_rad = 0.0;                  ///< how far the lever swings by itself; 0: locked
};

/// "triangle"; throws std::out_of_range for a name that is none.
std::string_view name_of(PlannedMotion::Kind kind);
PlannedMotion::Kind kind_named(std::string_view name);

/// Times from 0, deflection, input and output angle; corners rounded, as no actuator jumps.
ModuleSignals angles_of(const PlannedMotion& motion, double rate_hz);

/// "a triangle of 0.2 rad at 0.1 and 1 Hz for 60 s, output locked".
std::string words_for(const PlannedMotion& motion);

/// The [motion] table of a spec.
std::string to_toml(const PlannedMotion& motion);

}  // namespace searig::estimator
