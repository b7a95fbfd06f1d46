#include "estimator/twin/sensors.h"

#include <cmath>

namespace searig::estimator::twin {

Sensors::Sensors(const Parameters& parameters, std::uint64_t seed)
    : sensors_(parameters.sensors), arm_m_(parameters.lever.arm_m), random_(seed) {}

ModuleReading Sensors::module(const PlantState& state, double current_a,
                              double commanded_angle_rad) {
  const auto angle = [this](double truth) {
    return measured(truth, sensors_.encoder_noise_rad, sensors_.encoder_step_rad);
  };
  ModuleReading reading;
  reading.input_angle_rad = angle(state.input_angle_rad);
  reading.output_angle_rad = angle(state.output_angle_rad);
  reading.current_a = measured(current_a, sensors_.current_noise_a, sensors_.current_step_a);
  reading.commanded_angle_rad = commanded_angle_rad;
  return reading;
}

LoadcellReading Sensors::loadcell(const PlantState& state) {
  return {measured(-state.hand_torque_nm / arm_m_, sensors_.force_noise_n, sensors_.force_step_n)};
}

double Sensors::measured(double truth, double noise, double step) {
  const double noisy = truth + noise * normal_(random_);
  return step > 0.0 ? step * std::round(noisy / step) : noisy;
}

}  // namespace searig::estimator::twin
