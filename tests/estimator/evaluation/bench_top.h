// A module and a load cell of a test's own making, without noise: a spring, a motor with Coulomb
// friction, and the model that tells of both.
#pragma once

#include <cmath>

#include "estimator/model/model.h"
#include "estimator/signals.h"

namespace searig::estimator {

struct BenchTop {
  double k = 40;               ///< N*m/rad
  double loadcell_offset = 0;  ///< N*m
  double friction = 0.3;       ///< N*m
  double gain = 2;             ///< N*m/A at the gear output, efficiency included
  double smoothing = 0.01;     ///< rad/s, of the friction

  double angle(double t) const { return 0.3 * std::sin(3 * t) + 0.1 * std::sin(7 * t); }
  double velocity(double t) const { return 0.9 * std::cos(3 * t) + 0.7 * std::cos(7 * t); }

  /// The output is held by a second, stiffer spring: a quarter of the motion is deflection.
  double deflection(double t) const { return angle(t) / 4; }
  double torque(double t) const { return k * deflection(t); }
  double current(double t) const {
    return (torque(t) + friction * std::tanh(velocity(t) / smoothing)) / gain;
  }

  /// Telemetry at 500 Hz, load cell at 50 Hz, a quarter of a load-cell sample apart.
  Signals record(double seconds) const {
    Signals s;
    for (double t = 0; t < seconds; t += 0.002) {
      s.module.t_s.push_back(t);
      s.module.deflection_rad.push_back(deflection(t));
      s.module.input_angle_rad.push_back(angle(t));
      s.module.output_angle_rad.push_back(angle(t) - deflection(t));
      s.module.current_a.push_back(current(t));
    }
    for (double t = 0.005; t < seconds - 0.02; t += 0.02) {
      s.loadcell.t_s.push_back(t);
      s.loadcell.torque_nm.push_back(torque(t) + loadcell_offset);
    }
    return s;
  }

  Model model() const {
    Model m;
    m.terms = {{"spring.linear", {{"k_nm_per_rad", k}}},
               {"drive.motor", {{"torque_constant_nm_per_a", gain / 0.8}, {"efficiency", 0.8}}},
               {"drive.coulomb", {{"torque_nm", friction}, {"smoothing_rad_s", smoothing}}}};
    return m;
  }
};

}  // namespace searig::estimator
