#include "tests/proving/rig/simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/proving/rig/drive.h"
#include "tests/proving/rig/gauge.h"
#include "tests/proving/rig/oddity.h"
#include "tests/proving/rig/spring.h"

namespace searig::proving {
namespace {

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
  double stiffness, damping, torque_per_a, current_a = 0.0;
  Controller(const Baseline& b, const Hand& hand)
      : torque_per_a(b.efficiency * b.torque_constant_nm_per_a) {
    const double inertia = b.efficiency * b.inertia_kg_m2, k = b.stiffness_nm_per_rad;
    const double load = k * hand.stiffness_nm_per_rad / (k + hand.stiffness_nm_per_rad);
    stiffness = std::max(inertia * 60.0 * 60.0, 6.0 * load);
    damping = 1.4 * std::sqrt(stiffness * inertia);
  }
  double advance(const Generator& wanted, double angle, double velocity, double dt) {
    const double torque =
        stiffness * (wanted.position - angle) + damping * (wanted.velocity - velocity);
    current_a += (torque / torque_per_a - current_a) * std::min(1.0, dt / 1e-3);  // current loop
    return current_a;
  }
};

/// Leapfrog: velocities live half a step beside the angles, so both are of second order.
struct Axis {
  double angle = 0.0, half_velocity = 0.0, acceleration = 0.0;
  double velocity(double dt) const { return half_velocity + 0.5 * dt * acceleration; }
  double settle(double now, double dt) {  // the velocity at the angle's own instant
    const double mean = half_velocity + 0.5 * dt * now;
    acceleration = now;
    half_velocity += dt * now;
    angle += dt * half_velocity;
    return mean;
  }
};

struct Mechanism {
  Torques spring, drive;
  Gauges gauges;
  double gravity_nm = 0.0, gravity_phase_rad = 0.0, lever_inertia_kg_m2 = 0.0;

  explicit Mechanism(const Rig& rig) {
    for (const auto& e : rig.effects) {
      if (auto t = make_spring_torque(e, rig.base)) spring.push_back(std::move(t));
      if (auto t = make_odd_spring(e, rig.base)) spring.push_back(std::move(t));
      if (auto t = make_drive_torque(e, rig.base)) drive.push_back(std::move(t));
      if (auto t = make_odd_drive(e, rig.base)) drive.push_back(std::move(t));
      if (e.name == "rig.gravity")
        gravity_nm = e.at("torque_nm"), gravity_phase_rad = e.at("phase_rad");
      if (e.name == "rig.inertia") lever_inertia_kg_m2 = e.at("j_kg_m2");
    }
    // A load cell wanders and breaks before its reading is filtered and sent late.
    for (const auto& e : rig.effects)
      if (auto g = make_odd_gauge(e)) gauges.push_back(std::move(g));
    for (const auto& e : rig.effects)
      if (auto g = make_gauge(e)) gauges.push_back(std::move(g));
  }
};

void warm(const Thermal& thermal, Instant& now, double ambient_c, double lost_w, double dt) {
  const double winding = thermal.winding_rise_c_per_a2 * now.current_a * now.current_a;
  const double spring = thermal.spring_rise_c_per_w * lost_w;
  now.winding_c += dt / thermal.winding_tau_s * (ambient_c + winding - now.winding_c);
  now.spring_c += dt / thermal.spring_tau_s * (ambient_c + spring - now.spring_c);
}

}  // namespace

double Trace::at(const Channel& channel, double t_s) const {
  const double x =
      std::clamp((t_s - start_s) * rate_hz, 0.0, static_cast<double>(channel.size() - 2));
  const auto i = static_cast<std::size_t>(x);
  return channel[i] + (x - static_cast<double>(i)) * (channel[i + 1] - channel[i]);
}

Trace simulate(const Rig& rig) {
  const Baseline& b = rig.base;
  const Hand& hand = rig.hand;
  const double dt = Trace::step_s;
  Mechanism parts(rig);
  const auto dry_friction = make_coulomb(b);
  Generator wanted_motor(rig.plan.generator_hz), wanted_hand(rig.plan.generator_hz);
  Controller controller(b, hand);
  Axis input, output;
  Instant now;
  now.winding_c = now.spring_c = rig.thermal.start_c;
  Trace trace;
  // A little more than the recording, so that late samples and filters find something there.
  const auto steps = static_cast<std::size_t>((rig.duration_s + rig.preroll_s + 0.2) / dt);
  for (std::size_t n = 0; n < steps; ++n) {
    now.t_s = static_cast<double>(n) * dt - rig.preroll_s;
    const double t_motion = now.t_s + rig.preroll_s;
    wanted_motor.advance(Motion::at(rig.motion.motor_rad, t_motion), dt);
    wanted_hand.advance(Motion::at(rig.motion.hand_rad, t_motion), dt);

    now.input_angle_rad = input.angle, now.input_velocity_rad_s = input.velocity(dt);
    now.output_angle_rad = output.angle, now.output_velocity_rad_s = output.velocity(dt);
    now.deflection_rad = input.angle - output.angle;
    now.deflection_rate_rad_s = now.input_velocity_rad_s - now.output_velocity_rad_s;
    now.current_a = controller.advance(wanted_motor, input.angle, now.input_velocity_rad_s, dt);
    now.linear_torque_nm = b.stiffness_nm_per_rad * now.deflection_rad;
    now.spring_torque_nm = now.linear_torque_nm + sum(parts.spring, now, dt);

    // efficiency*j*a = efficiency*torque_constant*I - friction - T_spring
    const double coulomb = dry_friction->advance(now, dt);
    const double motor = b.efficiency * b.torque_constant_nm_per_a * now.current_a;
    const double drive = motor + coulomb - b.viscous_nm_s_per_rad * now.input_velocity_rad_s +
                         sum(parts.drive, now, dt);
    const double a_i = (drive - now.spring_torque_nm) / (b.efficiency * b.inertia_kg_m2);

    // (j_hand + j_lever)*a_o = T_spring - gravity - hand's impedance
    const double gravity = parts.gravity_nm * std::sin(output.angle + parts.gravity_phase_rad);
    const double held =
        hand.stiffness_nm_per_rad * (output.angle - wanted_hand.position) +
        hand.damping_nm_s_per_rad * (now.output_velocity_rad_s - wanted_hand.velocity);
    const double a_o =
        (now.spring_torque_nm - gravity - held) / (hand.inertia_kg_m2 + parts.lever_inertia_kg_m2);
    double reading = now.spring_torque_nm - gravity - parts.lever_inertia_kg_m2 * a_o;
    for (const auto& gauge : parts.gauges) reading = gauge->advance(reading, now, dt);

    const double ambient =
        rig.thermal.start_c + rig.thermal.ambient_drift_c_per_min * t_motion / 60.0;
    warm(rig.thermal, now, ambient, std::abs(now.spring_torque_nm * now.deflection_rate_rad_s), dt);

    const double q_i = input.angle, q_o = output.angle;
    const double w_i = input.settle(a_i, dt), w_o = output.settle(a_o, dt);
    if (n % Trace::stride != 0) continue;
    if (trace.input_angle_rad.empty()) trace.start_s = now.t_s;
    trace.input_angle_rad.push_back(q_i), trace.output_angle_rad.push_back(q_o);
    trace.input_velocity_rad_s.push_back(w_i), trace.output_velocity_rad_s.push_back(w_o);
    trace.input_acceleration_rad_s2.push_back(a_i), trace.output_acceleration_rad_s2.push_back(a_o);
    trace.current_a.push_back(now.current_a);
    trace.winding_c.push_back(now.winding_c), trace.spring_c.push_back(now.spring_c);
    trace.linear_torque_nm.push_back(now.linear_torque_nm);
    trace.spring_torque_nm.push_back(now.spring_torque_nm);
    trace.coulomb_nm.push_back(coulomb);
    trace.loadcell_torque_nm.push_back(reading);
  }
  return trace;
}

}  // namespace searig::proving
