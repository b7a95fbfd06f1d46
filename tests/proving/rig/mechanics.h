#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/proving/rig/rig.h"

namespace searig::proving {

/// A second-order trajectory generator: what the controller is given is smooth.
struct Generator {
  double omega, position = 0.0, velocity = 0.0;
  explicit Generator(double hz) : omega(2.0 * std::numbers::pi * hz) {}
  void advance(double wanted, double dt) {
    velocity += dt * omega * (omega * (wanted - position) - 2.0 * velocity);
    position += dt * velocity;
  }
};

/// Position control of the gear's output with the motor's current as its means.
struct Controller {
  static constexpr double bandwidth_rad_s = 60.0, current_loop_s = 1e-3;
  double stiffness, damping, torque_per_a, current_a = 0.0;

  Controller(const Baseline& b, const Hand& hand)
      : torque_per_a(b.efficiency * b.torque_constant_nm_per_a) {
    const double inertia = b.efficiency * b.inertia_kg_m2, k = b.stiffness_nm_per_rad;
    const double load = k * hand.stiffness_nm_per_rad / (k + hand.stiffness_nm_per_rad);
    stiffness = std::max(inertia * bandwidth_rad_s * bandwidth_rad_s, 6.0 * load);
    damping = 1.4 * std::sqrt(stiffness * inertia);
  }

  double advance(const Generator& wanted, double angle, double velocity, double dt) {
    const double torque =
        stiffness * (wanted.position - angle) + damping * (wanted.velocity - velocity);
    current_a += (torque / torque_per_a - current_a) * std::min(1.0, dt / current_loop_s);
    return current_a;
  }
};

/// Leapfrog: velocities live half a step beside the angles, so both are of second order.
struct Axis {
  double angle = 0.0, half_velocity = 0.0, acceleration = 0.0;

  double velocity(double dt) const { return half_velocity + 0.5 * dt * acceleration; }

  /// Moves on; answers the velocity at the instant that is left behind.
  double advance(double acceleration_now, double dt) {
    const double left = half_velocity + 0.5 * dt * acceleration_now;
    acceleration = acceleration_now;
    half_velocity += dt * acceleration_now;
    angle += dt * half_velocity;
    return left;
  }
};

}  // namespace searig::proving
