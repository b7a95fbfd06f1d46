// A forward simulation of the paper's module on its rig: pure code, its time is whatever the caller
// says. It shares no model code with the estimator's catalogue, so that the two can disagree.
#pragma once

#include <cstdint>

#include "estimator/twin/motion.h"
#include "estimator/twin/plant.h"
#include "estimator/twin/sensors.h"

namespace searig::estimator::twin {

class Twin {
 public:
  /// The same parameters and seed give the same experiment, bit for bit, however it is stepped.
  explicit Twin(const Parameters& parameters = {}, std::uint64_t seed = 1);

  /// Moves on to the last step at or before t_s. Time that is past stays past.
  void advance_to(double t_s);

  ModuleReading read_module();
  LoadcellReading read_loadcell();

  const Parameters& parameters() const { return parameters_; }
  /// The truth, for tests and for saying how far off an estimate is.
  const PlantState& state() const { return plant_.state(); }
  double stiffness_nm_per_rad() const { return plant_.spring().stiffness_nm_per_rad(); }
  double current_a() const { return current_a_; }

 private:
  void control();

  Parameters parameters_;
  MotionProgram motion_;
  Plant plant_;
  Sensors module_sensors_;
  Sensors loadcell_sensors_;  ///< with noise of its own: reading one changes nothing in the other
  std::uint64_t steps_ = 0;
  double current_a_ = 0.0;
  double commanded_angle_rad_ = 0.0;
};

}  // namespace searig::estimator::twin
