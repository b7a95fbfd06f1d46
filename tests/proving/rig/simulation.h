#pragma once

#include <vector>

#include "tests/proving/rig/rig.h"

namespace searig::proving {

/// What really happened, at an even rate. Nothing here is measured.
struct Trace {
  static constexpr double step_s = 1.0 / 6000.0;
  static constexpr int stride = 3;
  static constexpr double rate_hz = 1.0 / (step_s * stride);

  using Channel = std::vector<double>;
  double start_s = 0.0;
  Channel input_angle_rad, input_velocity_rad_s, input_acceleration_rad_s2;
  Channel output_angle_rad, output_velocity_rad_s, output_acceleration_rad_s2;
  Channel current_a, winding_c, spring_c;
  Channel linear_torque_nm;    ///< k*theta
  Channel spring_torque_nm;    ///< the whole spring
  Channel coulomb_nm;          ///< the baseline's dry friction, as it adds to T_drive
  Channel loadcell_torque_nm;  ///< what a noiseless load cell reports

  double at(const Channel& channel, double t_s) const;
};

Trace simulate(const Rig& rig);

}  // namespace searig::proving
