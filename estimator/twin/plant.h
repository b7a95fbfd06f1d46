// The bodies of the simulated rig and the torques between them; nothing here is measured.
#pragma once

#include "estimator/twin/parameters.h"
#include "estimator/twin/rubber_spring.h"

namespace searig::estimator::twin {

struct PlantState {
  double train_angle_rad = 0.0;  ///< motor angle over the gear ratio, before the backlash
  double train_velocity_rad_s = 0.0;
  double input_angle_rad = 0.0;   ///< q_i: the plate before the spring
  double output_angle_rad = 0.0;  ///< q_o: the plate behind it, and the lever
  double output_velocity_rad_s = 0.0;
  double spring_torque_nm = 0.0;
  double hand_torque_nm = 0.0;  ///< by which the hand turns the lever onwards
};

/// Motor and gears, backlash, spring, lever, hand.
class Plant {
 public:
  explicit Plant(const Parameters& parameters)
      : parameters_(parameters), spring_(parameters.spring) {}

  /// One step with the motor current and the angle to which the hand wants the lever.
  void step(double current_a, double hand_angle_rad, double dt_s);

  const PlantState& state() const { return state_; }
  const RubberSpring& spring() const { return spring_; }

 private:
  double friction_nm() const;
  void move_train(double current_a, double dt_s);
  void seat_input_plate();
  void move_lever(double hand_angle_rad, double dt_s);

  Parameters parameters_;
  RubberSpring spring_;
  PlantState state_;
};

}  // namespace searig::estimator::twin
