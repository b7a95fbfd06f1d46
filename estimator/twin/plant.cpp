#include "estimator/twin/plant.h"

#include <algorithm>
#include <cmath>

namespace searig::estimator::twin {

double RubberSpring::softness() const {
  return 1.0 -
         parameters_.softening_share * (1.0 - std::exp(-work_j_ / parameters_.softening_work_j));
}

double RubberSpring::stiffness_nm_per_rad() const {
  return softness() * parameters_.stiffness_nm_per_rad;
}

double RubberSpring::torque_nm(double deflection_rad) const {
  return softness() * (parameters_.stiffness_nm_per_rad * deflection_rad +
                       parameters_.loss_stiffness_nm_per_rad * (deflection_rad - relaxed_rad_));
}

double RubberSpring::rest_deflection_rad() const {
  // 0 = k*theta + k1*(theta - x)
  const double k = parameters_.stiffness_nm_per_rad, k1 = parameters_.loss_stiffness_nm_per_rad;
  return k1 * relaxed_rad_ / (k + k1);
}

void RubberSpring::step(double deflection_rad, double dt_s) {
  work_j_ += std::abs(torque_nm(deflection_rad) * (deflection_rad - deflection_rad_));
  deflection_rad_ = deflection_rad;
  // Exact for a deflection that holds over the step, so any step size is stable.
  relaxed_rad_ += (deflection_rad - relaxed_rad_) * -std::expm1(-dt_s / parameters_.loss_time_s);
}

void Plant::step(double current_a, double hand_angle_rad, double dt_s) {
  move_train(current_a, dt_s);
  move_lever(hand_angle_rad, dt_s);
  seat_input_plate();
  spring_.step(state_.input_angle_rad - state_.output_angle_rad, dt_s);
}

// J*a = tau*I - (T_spring + b*w + Coulomb) / efficiency
//
// Coulomb friction as an impulse: it takes away at most Tc*dt of momentum in a step and never turns
// the motion round. This holds the train exactly still while the other torques stay below Tc
// (J. J. Moreau, "Numerical aspects of the sweeping process", 1999).
void Plant::move_train(double current_a, double dt_s) {
  const auto& drive = parameters_.drive;
  const double current = std::clamp(current_a, -drive.current_limit_a, drive.current_limit_a);
  const double load =
      state_.spring_torque_nm + drive.viscous_nm_s_per_rad * state_.train_velocity_rad_s;
  const double pushing = drive.torque_constant_nm_per_a * current - load / drive.efficiency;
  const double free_velocity = state_.train_velocity_rad_s + dt_s * pushing / drive.inertia_kg_m2;
  const double most = dt_s * drive.coulomb_nm / drive.efficiency / drive.inertia_kg_m2;
  state_.train_velocity_rad_s = free_velocity - std::clamp(free_velocity, -most, most);
  state_.train_angle_rad += dt_s * state_.train_velocity_rad_s;
}

// J*a = T_spring + T_hand,  T_hand = K*(q_hand - q_o) - B*dq_o/dt
void Plant::move_lever(double hand_angle_rad, double dt_s) {
  const auto& lever = parameters_.lever;
  state_.hand_torque_nm =
      lever.hand_stiffness_nm_per_rad * (hand_angle_rad - state_.output_angle_rad) -
      lever.hand_damping_nm_s_per_rad * state_.output_velocity_rad_s;
  state_.output_velocity_rad_s +=
      dt_s * (state_.spring_torque_nm + state_.hand_torque_nm) / lever.inertia_kg_m2;
  state_.output_angle_rad += dt_s * state_.output_velocity_rad_s;
}

// The input plate is light: it sits where the spring leaves it in peace, unless the gears' teeth
// push it from one side or the other of the backlash.
void Plant::seat_input_plate() {
  const double gap = parameters_.drive.backlash_half_width_rad;
  state_.input_angle_rad = std::clamp(state_.output_angle_rad + spring_.rest_deflection_rad(),
                                      state_.train_angle_rad - gap, state_.train_angle_rad + gap);
  state_.spring_torque_nm = spring_.torque_nm(state_.input_angle_rad - state_.output_angle_rad);
}

}  // namespace searig::estimator::twin
