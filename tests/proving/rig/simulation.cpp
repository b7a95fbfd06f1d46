#include "tests/proving/rig/simulation.h"

#include <algorithm>
#include <cmath>

#include "tests/proving/rig/drive.h"
#include "tests/proving/rig/gauge.h"
#include "tests/proving/rig/mechanics.h"
#include "tests/proving/rig/oddity.h"
#include "tests/proving/rig/spring.h"

namespace searig::proving {
namespace {

constexpr double dt = Trace::step_s;

/// The rig's pieces of physics, each where it acts.
struct Parts {
  Torques spring, drive;
  Gauges gauges;
  std::unique_ptr<Torque> coulomb;
  double gravity_nm = 0.0, gravity_phase_rad = 0.0, lever_inertia_kg_m2 = 0.0;

  explicit Parts(const Rig& rig) : coulomb(make_coulomb(rig.base)) {
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

/// Motor and gear train -> spring -> lever with load cell -> hand, one step at a time.
class Stepper {
 public:
  explicit Stepper(const Rig& rig)
      : rig_(rig),
        parts_(rig),
        motor_wants_(rig.plan.generator_hz),
        hand_wants_(rig.plan.generator_hz),
        controller_(rig.base, rig.hand) {
    now_.winding_c = now_.spring_c = rig.thermal.start_c;
  }

  void advance(double t_motion_s, Trace* trace) {
    motor_wants_.advance(Motion::at(rig_.motion.motor_rad, t_motion_s), dt);
    hand_wants_.advance(Motion::at(rig_.motion.hand_rad, t_motion_s), dt);
    feel(t_motion_s - rig_.preroll_s);
    const double a_i = input_acceleration(), a_o = output_acceleration();
    const double reading = loadcell(a_o);
    warm(t_motion_s);
    const double w_i = input_.advance(a_i, dt), w_o = output_.advance(a_o, dt);
    if (trace) report(*trace, a_i, w_i, a_o, w_o, reading);
  }

 private:
  void feel(double t_s) {
    now_.t_s = t_s;
    now_.input_angle_rad = input_.angle;
    now_.input_velocity_rad_s = input_.velocity(dt);
    now_.output_angle_rad = output_.angle;
    now_.output_velocity_rad_s = output_.velocity(dt);
    now_.deflection_rad = input_.angle - output_.angle;
    now_.deflection_rate_rad_s = now_.input_velocity_rad_s - now_.output_velocity_rad_s;
    now_.current_a = controller_.advance(motor_wants_, input_.angle, now_.input_velocity_rad_s, dt);
    now_.linear_torque_nm = rig_.base.stiffness_nm_per_rad * now_.deflection_rad;
    now_.spring_torque_nm = now_.linear_torque_nm + sum(parts_.spring, now_, dt);
    coulomb_nm_ = parts_.coulomb->advance(now_, dt);
  }

  /// efficiency*j*a = efficiency*torque_constant*I - friction - T_spring
  double input_acceleration() {
    const Baseline& b = rig_.base;
    const double motor = b.efficiency * b.torque_constant_nm_per_a * now_.current_a;
    const double viscous = -b.viscous_nm_s_per_rad * now_.input_velocity_rad_s;
    const double drive = motor + coulomb_nm_ + viscous + sum(parts_.drive, now_, dt);
    return (drive - now_.spring_torque_nm) / (b.efficiency * b.inertia_kg_m2);
  }

  double gravity() const {
    return parts_.gravity_nm * std::sin(output_.angle + parts_.gravity_phase_rad);
  }

  /// (j_hand + j_lever)*a_o = T_spring - gravity - hand's impedance
  double output_acceleration() const {
    const Hand& hand = rig_.hand;
    const double held =
        hand.stiffness_nm_per_rad * (output_.angle - hand_wants_.position) +
        hand.damping_nm_s_per_rad * (now_.output_velocity_rad_s - hand_wants_.velocity);
    return (now_.spring_torque_nm - gravity() - held) /
           (hand.inertia_kg_m2 + parts_.lever_inertia_kg_m2);
  }

  double loadcell(double a_o) {
    double torque = now_.spring_torque_nm - gravity() - parts_.lever_inertia_kg_m2 * a_o;
    for (const auto& gauge : parts_.gauges) torque = gauge->advance(torque, now_, dt);
    return torque;
  }

  void warm(double t_motion_s) {
    const Thermal& thermal = rig_.thermal;
    const double ambient = thermal.start_c + thermal.ambient_drift_c_per_min * t_motion_s / 60.0;
    const double winding = thermal.winding_rise_c_per_a2 * now_.current_a * now_.current_a;
    const double spring =
        thermal.spring_rise_c_per_w * std::abs(now_.spring_torque_nm * now_.deflection_rate_rad_s);
    now_.winding_c += dt / thermal.winding_tau_s * (ambient + winding - now_.winding_c);
    now_.spring_c += dt / thermal.spring_tau_s * (ambient + spring - now_.spring_c);
  }

  void report(Trace& trace, double a_i, double w_i, double a_o, double w_o, double reading) const {
    if (trace.input_angle_rad.empty()) trace.start_s = now_.t_s;
    trace.input_angle_rad.push_back(now_.input_angle_rad);
    trace.input_velocity_rad_s.push_back(w_i);
    trace.input_acceleration_rad_s2.push_back(a_i);
    trace.output_angle_rad.push_back(now_.output_angle_rad);
    trace.output_velocity_rad_s.push_back(w_o);
    trace.output_acceleration_rad_s2.push_back(a_o);
    trace.current_a.push_back(now_.current_a);
    trace.winding_c.push_back(now_.winding_c);
    trace.spring_c.push_back(now_.spring_c);
    trace.linear_torque_nm.push_back(now_.linear_torque_nm);
    trace.spring_torque_nm.push_back(now_.spring_torque_nm);
    trace.coulomb_nm.push_back(coulomb_nm_);
    trace.loadcell_torque_nm.push_back(reading);
  }

  const Rig& rig_;
  Parts parts_;
  Generator motor_wants_, hand_wants_;
  Controller controller_;
  Axis input_, output_;
  Instant now_;
  double coulomb_nm_ = 0.0;
};

}  // namespace

double Trace::at(const Channel& channel, double t_s) const {
  const double x =
      std::clamp((t_s - start_s) * rate_hz, 0.0, static_cast<double>(channel.size() - 2));
  const auto i = static_cast<std::size_t>(x);
  return channel[i] + (x - static_cast<double>(i)) * (channel[i + 1] - channel[i]);
}

Trace simulate(const Rig& rig) {
  Stepper stepper(rig);
  Trace trace;
  // A little more than the recording, so that late samples and filters find something there.
  const auto steps = static_cast<std::size_t>((rig.duration_s + rig.preroll_s + 0.2) / dt);
  for (std::size_t n = 0; n < steps; ++n)
    stepper.advance(static_cast<double>(n) * dt, n % Trace::stride == 0 ? &trace : nullptr);
  return trace;
}

}  // namespace searig::proving
