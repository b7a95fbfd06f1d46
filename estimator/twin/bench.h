// What a maker does with a module before the experiment: works a spring to and fro, and measures
// the gear train's efficiency.
#pragma once

#include <vector>

#include "estimator/twin/parameters.h"

namespace searig::estimator::twin {

/// Strokes of one amplitude on a spring alone. As many samples for each cycle, and one that closes
/// the last; the stiffness once for each cycle.
struct SpringCycles {
  std::vector<double> t_s;
  std::vector<double> deflection_rad;
  std::vector<double> torque_nm;
  std::vector<double> stiffness_nm_per_rad;  ///< of each cycle: slope of torque over deflection
};

SpringCycles cycle_spring(const SpringParameters& spring, double amplitude_rad, double hz,
                          int cycles);

/// eta of the paper's equation (2), measured as it is done with gears: the module raises a load at
/// constant speed, and eta is the load over torque constant times current.
double measured_efficiency(const Parameters& module, double load_nm, double velocity_rad_s);

}  // namespace searig::estimator::twin
