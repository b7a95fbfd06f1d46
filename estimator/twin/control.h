// The module's own position loop.
#pragma once

#include <algorithm>

#include "estimator/twin/plant.h"

namespace searig::estimator::twin {

/// I = Kp*(commanded - train) - Kd*w, limited as the amplifier limits it.
inline double loop_current_a(const Parameters& module, double commanded_angle_rad,
                             const PlantState& state) {
  const auto& [period_s, proportional, derivative] = module.controller;
  const double wanted = proportional * (commanded_angle_rad - state.train_angle_rad) -
                        derivative * state.train_velocity_rad_s;
  return std::clamp(wanted, -module.drive.current_limit_a, module.drive.current_limit_a);
}

}  // namespace searig::estimator::twin
