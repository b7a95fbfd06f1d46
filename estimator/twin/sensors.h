// What the rig's sensors make of the truth: noise, then steps.
#pragma once

#include <cstdint>
#include <random>

#include "estimator/twin/plant.h"

namespace searig::estimator::twin {

struct ModuleReading {
  double input_angle_rad = 0.0;
  double output_angle_rad = 0.0;
  double current_a = 0.0;
  double commanded_angle_rad = 0.0;
};

struct LoadcellReading {
  double force_n = 0.0;
};

class Sensors {
 public:
  Sensors(const Parameters& parameters, std::uint64_t seed);

  ModuleReading module(const PlantState& state, double current_a, double commanded_angle_rad);
  /// The load cell sits between lever and hand: positive where the spring torque is positive.
  LoadcellReading loadcell(const PlantState& state);

 private:
  double measured(double truth, double noise, double step);

  SensorParameters sensors_;
  double arm_m_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
};

}  // namespace searig::estimator::twin
