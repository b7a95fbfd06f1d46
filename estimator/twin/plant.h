// The bodies of the simulated rig and the torques between them; nothing here is measured.
#pragma once

#include "estimator/twin/parameters.h"

namespace searig::estimator::twin {

/// The rubber between input and output plate.
///
///   T = s * (k*theta + k1*(theta - x)),   dx/dt = (theta - x)/tau      (standard linear solid)
///   s = 1 - share*(1 - exp(-W/W0)),       W = integral of |T dtheta|   (softening with work done)
class RubberSpring {
 public:
  explicit RubberSpring(const SpringParameters& parameters) : parameters_(parameters) {}

  double torque_nm(double deflection_rad) const;
  /// The deflection at which the spring pushes on neither plate.
  double rest_deflection_rad() const;
  /// What k is now, softened.
  double stiffness_nm_per_rad() const;
  void step(double deflection_rad, double dt_s);

 private:
  double softness() const;

  SpringParameters parameters_;
  double relaxed_rad_ = 0.0;  ///< x
  double deflection_rad_ = 0.0;
  double work_j_ = 0.0;  ///< W
};

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
  void move_train(double current_a, double dt_s);
  void seat_input_plate();
  void move_lever(double hand_angle_rad, double dt_s);

  Parameters parameters_;
  RubberSpring spring_;
  PlantState state_;
};

}  // namespace searig::estimator::twin
