#include "estimator/twin/plant.h"

#include <algorithm>
#include <cmath>

namespace searig::estimator::twin {

void Plant::step(double current_a, double hand_angle_rad, double dt_s) {
  move_train(current_a, dt_s);
  move_lever(hand_angle_rad, dt_s);
  seat_input_plate();
  spring_.step(state_.input_angle_rad - state_.output_angle_rad, dt_s);
}

// Tf = Tc + Ts*exp(-(w/ws)^2) + mu*|T_spring|: dry friction of the idle train, what sticking adds,
// and what the load adds in the teeth. Whichever way the train turns it costs the same, so that the
// train is more efficient when driven than when driven back.
double Plant::friction_nm() const {
  const auto& drive = parameters_.drive;
  const double slow = state_.train_velocity_rad_s / drive.stribeck_velocity_rad_s;
  return drive.coulomb_nm + drive.stribeck_nm * std::exp(-slow * slow) +
         drive.load_friction_share * std::abs(state_.spring_torque_nm);
}

// J*a = tau*I - (T_spring + b*w + Tf) / efficiency
//
// Dry friction as an impulse: it takes away at most Tf*dt of momentum in a step and never turns
// the motion round. This holds the train exactly still while the other torques stay below Tf
// (J. J. Moreau, "Numerical aspects of the sweeping process", 1999).
void Plant::move_train(double current_a, double dt_s) {
  const auto& drive = parameters_.drive;
  const double current = std::clamp(current_a, -drive.current_limit_a, drive.current_limit_a);
  const double load =
      state_.spring_torque_nm + drive.viscous_nm_s_per_rad * state_.train_velocity_rad_s;
  const double pushing = drive.torque_constant_nm_per_a * current - load / drive.efficiency;
  const double free_velocity = state_.train_velocity_rad_s + dt_s * pushing / drive.inertia_kg_m2;
  const double most = dt_s * friction_nm() / drive.efficiency / drive.inertia_kg_m2;
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
