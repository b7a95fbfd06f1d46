#include "estimator/twin/bench.h"

#include <cmath>
#include <numbers>

#include "estimator/twin/control.h"
#include "estimator/twin/plant.h"

namespace searig::estimator::twin {
namespace {

/// The slope of the least-squares line through the samples [from, end).
double slope(const std::vector<double>& x, const std::vector<double>& y, std::size_t from) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = from; i < x.size(); ++i) {
    n += 1, sx += x[i], sy += y[i], sxx += x[i] * x[i], sxy += x[i] * y[i];
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace

SpringCycles cycle_spring(const SpringParameters& parameters, double amplitude_rad, double hz,
                          int cycles) {
  constexpr int per_cycle = 1000, kept_every = 5;
  const double dt_s = 1.0 / hz / per_cycle;
  RubberSpring spring(parameters);
  SpringCycles out;
  for (int cycle = 0; cycle < cycles; ++cycle) {
    const std::size_t first = out.t_s.size();
    for (int i = 0; i < per_cycle; ++i) {
      const double t_s = (cycle * per_cycle + i) * dt_s;
      const double deflection = amplitude_rad * std::sin(2.0 * std::numbers::pi * hz * t_s);
      spring.step(deflection, dt_s);
      if (i % kept_every != 0) continue;
      out.t_s.push_back(t_s);
      out.deflection_rad.push_back(deflection);
      out.torque_nm.push_back(spring.torque_nm(deflection));
    }
    out.stiffness_nm_per_rad.push_back(slope(out.deflection_rad, out.torque_nm, first));
  }
  out.t_s.push_back(cycles / hz);  // closes the last loop
  out.deflection_rad.push_back(0.0);
  out.torque_nm.push_back(spring.torque_nm(0.0));
  return out;
}

double measured_efficiency(const Parameters& module, double load_nm, double velocity_rad_s) {
  constexpr double dt_s = 1e-4, settle_s = 2.0, measure_s = 2.0;
  Plant plant(module);
  const auto& lever = module.lever;
  double load_sum = 0.0, current_sum = 0.0;
  for (double t_s = 0.0; t_s < settle_s + measure_s; t_s += dt_s) {
    // The hand lets itself be pulled, by as much as its arm gives under the load.
    const auto& state = plant.state();
    const double give = load_nm / lever.hand_stiffness_nm_per_rad -
                        lever.hand_damping_nm_s_per_rad / lever.hand_stiffness_nm_per_rad *
                            state.output_velocity_rad_s;
    const double current = loop_current_a(module, velocity_rad_s * t_s, state);
    plant.step(current, state.output_angle_rad - give, dt_s);
    if (t_s < settle_s) continue;
    load_sum -= plant.state().hand_torque_nm;
    current_sum += current;
  }
  return load_sum / (module.drive.torque_constant_nm_per_a * current_sum);
}

}  // namespace searig::estimator::twin
