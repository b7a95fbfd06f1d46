#pragma once

#include "tests/proving/plan/stratum.h"
#include "tests/proving/rig/rig.h"
#include "tests/proving/sensing/recording.h"

namespace searig::proving {

/// What a simulated motion amounts to; amplitudes are drawn against it.
struct Statistics {
  double torque_rms_nm, torque_peak_nm, deflection_rms_rad, deflection_peak_rad;
  double rate_rms_rad_s, velocity_rms_rad_s, acceleration_rms_rad_s2,
      output_acceleration_rms_rad_s2;
  double current_rms_a, input_peak_rad, output_peak_rad, winding_span_c, spring_span_c;
};
Statistics statistics_of(const Trace& trace, const Rig& rig);

/// A rig of some size, held by some hand, asked for motions that the item's effects can show in.
Rig draw_rig(const Item& item, Random random);

/// Encoders, load cell, links and clocks that suit the rig's torques.
Sensing draw_sensing(const Item& item, const Rig& rig, const Statistics& stats, Random random);

}  // namespace searig::proving
