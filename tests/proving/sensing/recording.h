#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tests/proving/rig/simulation.h"
#include "tests/proving/sensing/clock.h"
#include "tests/proving/sensing/noise.h"

namespace searig::proving {

/// How a rig is watched.
struct Sensing {
  double module_rate_hz = 250.0, loadcell_rate_hz = 50.0;
  DeviceClock module_clock, loadcell_clock;
  LinkPlan module_link, loadcell_link;
  double angle_step_rad = 3.8e-4, current_step_a = 0.005, force_step_n = 0.01;
  double interpolation_error_rad = 0.0;  ///< of the encoder, twice per step: below half a step
  double loadcell_offset_nm = 0.0, deflection_offset_rad = 0.0;
  bool temperatures = false;
  NoisePlan noise;
  double torque_rms_nm = 1.0;
  std::uint64_t seed = 1;
};

/// What ends up in the two files. true_s is for the sealed side only.
struct ModuleRow {
  double true_s, t_s, host_s, input_angle_rad, output_angle_rad, current_a, winding_c, spring_c;
};
struct LoadcellRow {
  double true_s, t_s, host_s;
  int seq;
  double force_n;
};
struct Recording {
  std::vector<ModuleRow> module;
  std::vector<LoadcellRow> loadcell;
};

Recording observe(const Trace& trace, const Rig& rig, const Sensing& sensing);

}  // namespace searig::proving
