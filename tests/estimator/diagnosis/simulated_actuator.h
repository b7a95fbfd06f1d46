// A module and a load cell of a test's own making: formulas on a multisine, no integrator, so that
// nothing is shared with the simulations that the estimator comes with.
#pragma once

#include <cmath>
#include <random>

#include "estimator/model/model.h"
#include "estimator/signals.h"

namespace searig::estimator {

struct SimulatedActuator {
  double seconds = 36;
  double k = 40;           ///< N*m/rad
  double gain = 2;         ///< N*m/A at the gear output, efficiency 0.8 included
  double viscous = 0;      ///< N*m*s/rad, of the spring
  double cubic = 0;        ///< N*m/rad^3
  double coulomb = 0;      ///< N*m, in the drive
  double noise_nm = 0.03;  ///< of the load cell
  double memory = 0;       ///< of that noise from one sample to the next
  double noise_a = 0.01;   ///< of the current
  double module_step_s = 0.005, loadcell_step_s = 0.02;
  bool one_sine = false;  ///< 1 Hz alone: little can be told apart
  unsigned seed = 1;

  struct Wave {
    double value = 0, rate = 0, bend = 0;
    void add(double amplitude, double hz, double phase, double t) {
      const double w = 2 * M_PI * hz, x = w * t + phase;
      value += amplitude * std::sin(x);
      rate += amplitude * w * std::cos(x);
      bend -= amplitude * w * w * std::sin(x);
    }
  };
  /// Up to 2.3 Hz; the lever moves too, or deflection and input could not be told apart.
  static Wave deflection(double t) {
    Wave out;
    out.add(0.12, 0.23, 0.3, t), out.add(0.08, 0.71, 1.1, t);
    out.add(0.05, 1.37, 2.0, t), out.add(0.02, 2.3, 0.5, t);
    return out;
  }
  static Wave output(double t) {
    Wave out;
    out.add(0.3, 0.17, 1.9, t), out.add(0.1, 0.53, 0.2, t), out.add(0.04, 1.1, 0.8, t);
    return out;
  }

  Wave bent(double t) const {
    if (!one_sine) return deflection(t);
    Wave out;
    out.add(0.12, 1.0, 0.0, t);
    return out;
  }
  Wave swung(double t) const {
    if (!one_sine) return output(t);
    Wave out;
    out.add(0.1, 1.0, 1.9, t);
    return out;
  }

  double torque(double t) const {
    const Wave d = bent(t);
    return k * d.value + viscous * d.rate + cubic * std::pow(d.value, 3);
  }

  Signals record() const {
    std::mt19937 random(seed);
    std::normal_distribution<double> gauss;
    Signals s;
    for (double t = 0; t < seconds; t += module_step_s) {
      const Wave d = bent(t), o = swung(t);
      const double w = d.rate + o.rate, a = d.bend + o.bend;
      s.module.t_s.push_back(t);
      s.module.deflection_rad.push_back(d.value);
      s.module.output_angle_rad.push_back(o.value);
      s.module.input_angle_rad.push_back(d.value + o.value);
      const double drive = torque(t) + coulomb * std::tanh(w / 0.01) + 0.8 * 0.01 * a;
      s.module.current_a.push_back(drive / gain + noise_a * gauss(random));
    }
    double noise = 0;
    const double fresh = noise_nm * std::sqrt(1 - memory * memory);
    for (double t = 0.007; t < seconds - 0.02; t += loadcell_step_s) {
      noise = memory * noise + fresh * gauss(random);
      s.loadcell.t_s.push_back(t);
      s.loadcell.torque_nm.push_back(torque(t) + noise);
    }
    return s;
  }

  /// What the plain actuator is: nothing beyond the paper's two equations.
  Model paper() const {
    Model m;
    m.set("spring.linear", "k_nm_per_rad", k);
    m.set("drive.motor", "torque_constant_nm_per_a", gain / 0.8);
    m.set("drive.motor", "efficiency", 0.8);
    m.set("drive.inertia", "j_kg_m2", 0.01);
    return m;
  }
};

}  // namespace searig::estimator
