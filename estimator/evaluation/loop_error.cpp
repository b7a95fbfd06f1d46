#include "estimator/evaluation/loop_error.h"

#include <cstddef>

namespace searig::estimator {

std::optional<std::string> take_loop_error_for_current(Signals& signals,
                                                       std::optional<double> gain_a_per_rad) {
  ModuleSignals& module = signals.module;
  module.current_a.clear();
  const bool on_motor_side = !module.motor_angle_rad.empty();
  const auto& angle = on_motor_side ? module.motor_angle_rad : module.input_angle_rad;
  const double per_turn = on_motor_side ? 1 / signals.gear_ratio : 1;
  if (module.commanded_angle_rad.empty() || angle.empty()) {
    return "no commanded angle and angle of the loop: there is no control-loop error to take";
  }
  for (std::size_t i = 0; i < angle.size(); ++i) {
    const double error = module.commanded_angle_rad[i] - angle[i] * per_turn;
    module.current_a.push_back(gain_a_per_rad.value_or(1) * error);
  }
  return std::nullopt;
}

}  // namespace searig::estimator
