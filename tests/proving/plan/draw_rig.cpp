#include "tests/proving/plan/draw_rig.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/proving/plan/draw_motion.h"

namespace searig::proving {
namespace {

double rms(const Trace::Channel& c) {
  double squares = 0.0;
  for (const double v : c) squares += v * v;
  return std::sqrt(squares / static_cast<double>(c.size()));
}

double peak(const Trace::Channel& c) {
  double p = 0.0;
  for (const double v : c) p = std::max(p, std::abs(v));
  return p;
}

double span(const Trace::Channel& c) {
  const auto [low, high] = std::minmax_element(c.begin(), c.end());
  return *high - *low;
}

Trace::Channel difference(const Trace::Channel& a, const Trace::Channel& b) {
  Trace::Channel out(a.size());
  std::transform(a.begin(), a.end(), b.begin(), out.begin(), std::minus<>());
  return out;
}

/// A lever clamped to the bench calibrates a spring as well, but says nothing about the lever.
bool may_be_locked(const Item& item) {
  return item.stratum == "null exact" ||
         (item.level == "single" && item.effects.front().starts_with("spring."));
}

}  // namespace

Statistics statistics_of(const Trace& t, const Rig& rig) {
  const auto deflection = difference(t.input_angle_rad, t.output_angle_rad);
  const auto rate = difference(t.input_velocity_rad_s, t.output_velocity_rad_s);
  const double k = rig.base.stiffness_nm_per_rad;
  return {k * rms(deflection),
          k * peak(deflection),
          rms(deflection),
          peak(deflection),
          rms(rate),
          rms(t.input_velocity_rad_s),
          rms(t.input_acceleration_rad_s2),
          rms(t.output_acceleration_rad_s2),
          rms(t.current_a),
          peak(t.input_angle_rad),
          peak(t.output_angle_rad),
          span(t.winding_c),
          span(t.spring_c)};
}

Rig draw_rig(const Item& item, Random random) {
  Rig rig;
  Baseline& b = rig.base;
  const double k = b.stiffness_nm_per_rad = random.log_uniform(2.0, 3000.0);
  // Stiff springs turn less: 0.2 rad at 2 N*m/rad, 0.018 rad at 3000.
  const double deflection = 0.2 * std::pow(k / 2.0, -0.33) * random.log_uniform(0.75, 1.33);
  const double torque_peak = std::clamp(k * deflection, 0.3, 60.0), torque = 0.42 * torque_peak;

  rig.duration_s = std::round(random.log_uniform(60.0, 140.0));
  rig.preroll_s = item.variant == "initial state" ? 6.0 : 1.5;
  MotionPlan& plan = rig.plan = draw_motion(item, random.fork("motion plan"));
  const bool locked = may_be_locked(item) && random.chance(0.12);
  if (locked) plan.motor_amplitude_rad = deflection, plan.hand_amplitude_rad = 0.0;
  rig.motion = plan_motion(plan, rig.duration_s + rig.preroll_s, random.fork("motion"));
  const double swing = plan.motor_amplitude_rad;
  const double speed = 1.9 * (locked ? 0.5 : swing) * plan.pace;  // what the gear train is made for

  b.gear_ratio =
      random.pick(std::vector<double>{6, 10, 16, 25, 50, 80, 100, 121, 160, 200, 300, 349, 400});
  b.lever_arm_m = std::round(random.uniform(0.05, 0.4) * 100.0) / 100.0;
  b.efficiency = random.uniform(0.62, 0.9);
  b.torque_constant_nm_per_a = torque / (b.efficiency * random.log_uniform(0.5, 5.0));
  b.coulomb_nm = random.uniform(0.06, 0.14) * torque;
  b.viscous_nm_s_per_rad = random.uniform(0.05, 0.12) * torque / speed;
  b.inertia_kg_m2 = random.uniform(0.025, 0.07) * torque / (6.0 * speed * b.efficiency);
  // Dry friction turns over before the speed reaches what the owner's smoothing hides.
  b.bristle_rad = std::max(random.log_uniform(1.5e-5, 4e-5),
                           b.coulomb_nm / (b.efficiency * b.inertia_kg_m2 * 800.0 * 800.0));

  // The hand gives way by as much as the motor's swing allows: series stiffness = torque/swing.
  const double series = locked ? 0.97 * k : std::min(torque_peak / (1.15 * swing), 0.8 * k);
  const double stiff = rig.hand.stiffness_nm_per_rad = series * k / (k - series);
  const double omega = random.uniform(50.0, 90.0) * (locked ? 5.0 : 1.0),
               ratio = random.uniform(0.5, 0.9);
  rig.hand.inertia_kg_m2 = (k + stiff) / (omega * omega);
  rig.hand.damping_nm_s_per_rad = 2.0 * ratio * rig.hand.inertia_kg_m2 * omega;

  rig.thermal.start_c = random.uniform(20.0, 27.0);
  rig.thermal.winding_tau_s = random.uniform(15.0, 45.0);
  rig.thermal.spring_tau_s = random.uniform(20.0, 60.0);
  const double current = torque / (b.efficiency * b.torque_constant_nm_per_a);
  rig.thermal.winding_rise_c_per_a2 = random.uniform(15.0, 45.0) / (current * current);
  rig.thermal.spring_rise_c_per_w = random.uniform(4.0, 12.0) / (torque * 2.0 * deflection);
  rig.thermal.ambient_drift_c_per_min = random.sign() * random.uniform(1.0, 5.0);
  return rig;
}

Sensing draw_sensing(const Item& item, const Rig& rig, const Statistics& stats, Random random) {
  Sensing s;
  s.seed = random.bits();
  s.torque_rms_nm = stats.torque_rms_nm;
  s.module_rate_hz =
      random.pick(std::vector<double>{100, 200, 200, 250, 250, 250, 333, 400, 500, 500, 1000});
  s.loadcell_rate_hz = random.pick(std::vector<double>{20, 40, 50, 50, 50, 80, 80, 80, 100, 200});
  s.module_clock = {random.uniform(-60.0, 60.0), random.uniform(0.0, 500.0),
                    random.chance(0.5) ? 1e-4 : 1e-6};
  s.loadcell_clock = {random.uniform(-2500.0, 2500.0), random.uniform(0.0, 900.0),
                      random.chance(0.5) ? 4e-6 : 1e-6};
  s.module_link = {random.uniform(1.5e-4, 8e-4), random.uniform(1e-4, 4e-4), 0.0, 0.0, 0.0, 0.0};
  s.loadcell_link = {random.uniform(5e-4, 3.2e-3), random.uniform(1e-3, 5e-3), 0.0, 0.0, 0.0, 0.0};
  if (random.chance(0.4))
    s.loadcell_link.usb_timer_s = random.pick(std::vector<double>{1e-3, 4e-3, 16e-3});
  if (random.chance(0.4)) {
    s.module_link.stall_chance = 0.1 / s.module_rate_hz, s.module_link.stall_s = 0.05;
    s.loadcell_link.stall_chance = 0.1 / s.loadcell_rate_hz, s.loadcell_link.stall_s = 0.12;
  }
  if (random.chance(0.5))
    s.module_link.loss_chance = s.loadcell_link.loss_chance = random.log_uniform(2e-4, 4e-3);

  NoisePlan& n = s.noise;
  n.loadcell_rms_nm = random.log_uniform(0.003, 0.008) * stats.torque_rms_nm;
  n.loadcell_kind =
      random.pick(std::vector<std::string>{"white", "white", "white", "white", "ar0.6", "ar0.9",
                                           "ar0.97", "hum", "loud_when_loaded", "outliers"});
  // Hum at a multiple of the sampling rate would be a slow wave in time: that is no noise.
  if (n.loadcell_kind == "hum" && s.loadcell_rate_hz == 50.0) s.loadcell_rate_hz = 80.0;
  // After the 10 ms smoothing the drive is between as loud and twice as loud as the load cell.
  const double torque_per_a = rig.base.efficiency * rig.base.torque_constant_nm_per_a;
  n.current_rms_a = random.uniform(0.7, 2.0) * n.loadcell_rms_nm / torque_per_a *
                    std::sqrt(std::max(1.0, s.module_rate_hz / 50.0));
  // The encoder's own rounding stays below the load cell's noise.
  const double wanted =
      random.uniform(0.4, 1.2) * n.loadcell_rms_nm / rig.base.stiffness_nm_per_rad;
  const double turn = 2.0 * std::numbers::pi;
  s.angle_step_rad = turn / std::exp2(std::ceil(std::log2(turn / wanted)));
  s.interpolation_error_rad = random.chance(0.3) ? 0.2 * s.angle_step_rad : 0.0;
  s.current_step_a = std::exp2(std::floor(std::log2(0.5 * n.current_rms_a)));
  s.force_step_n = std::exp2(
      std::floor(std::log2(random.uniform(0.2, 0.8) * n.loadcell_rms_nm / rig.base.lever_arm_m)));
  const bool thermal_effect =
      std::any_of(item.effects.begin(), item.effects.end(),
                  [](const auto& e) { return e.find("temperature") != std::string::npos; });
  s.temperatures = thermal_effect || random.chance(0.3);
  if (item.variant == "load-cell offset" || item.variant == "every number")
    s.loadcell_offset_nm = random.sign() * random.uniform(0.01, 0.06) * stats.torque_rms_nm;
  if (item.variant == "deflection offset")
    s.deflection_offset_rad = random.sign() * random.uniform(0.01, 0.08) * stats.deflection_rms_rad;
  return s;
}

}  // namespace searig::proving
