#include "estimator/twin/paper_module.h"

#include <cstdio>
#include <numbers>
#include <random>

namespace searig::estimator::twin {
namespace {

constexpr double spread = 0.1;  // paper, section IV-C: "as much as a 10 % variation"

std::string with_unit(double value, const char* unit) {
  char text[64];
  std::snprintf(text, sizeof text, "%.3g %s", value, unit);
  return text;
}

std::vector<Fact> spring_facts(const SpringParameters& spring) {
  std::string branches;
  for (const auto& branch : spring.branches) {
    branches += (branches.empty() ? "" : ", ") + with_unit(branch.stiffness_nm_per_rad, "N·m/rad") +
                " at " + with_unit(branch.time_s, "s");
  }
  return {
      {"stiffness at rest, unworn", with_unit(spring.stiffness_nm_per_rad, "N·m/rad"), "",
       "the paper prints no stiffness; its 6 N·m then turn the spring by less than 10 degrees"},
      {"from one spring to the next", "even within ±10 %", "section IV-C",
       "as much as a 10 % variation between nominally equal springs"},
      {"softening by work", with_unit(100 * spring.softening_share, "%"), "figure 3",
       "the spring constant changed by about 25 % (Mullins effect)"},
      {"work for 63 % of the softening", with_unit(spring.softening_work_j, "J"), "",
       "about a dozen full strokes; most of a Mullins effect comes with the first strokes"},
      {"recovery at rest", with_unit(spring.recovery_time_s / 60, "min"), "section IV-C",
       "the paper says that it recovers, not how fast; half an hour is chosen"},
      {"softening that is there when a trial begins", "even within 0 and 1", "",
       "between rested and worked through: the paper does not say how long its springs had rested"},
      {"branches that relax (Maxwell)", branches, "",
       "the paper calls the rubber viscoelastic and gives no number; a decade apart and 15 % each "
       "they make a loss factor of about 0.08 at a hand's pace, as filled rubber has"}};
}

std::vector<Fact> drive_facts(const DriveParameters& drive) {
  return {{"gear ratio", with_unit(drive.gear_ratio, ": 1"), "section III", ""},
          {"torque constant at the output", with_unit(drive.torque_constant_nm_per_a, "N·m/A"), "",
           "7.4 mN·m/A at the motor, a small brushless one"},
          {"largest current", with_unit(drive.current_limit_a, "A"), "",
           "with the losses 7.7 N·m at the output: figure 1 says over 6 N·m"},
          {"inertia at the output", with_unit(drive.inertia_kg_m2, "kg·m²"), "",
           "a rotor of 1e-7 kg·m² times 349²"},
          {"dry friction of the idle train", with_unit(drive.coulomb_nm, "N·m"), "",
           "1.1 mN·m at the rotor; figures 4 and 7 show the sticking, section IV-C names it"},
          {"what sticking adds (Stribeck)",
           with_unit(drive.stribeck_nm, "N·m below about ") +
               with_unit(drive.stribeck_velocity_rad_s, "rad/s"),
           "", "half as much again, at a rotor speed of 17 rad/s"},
          {"friction per torque through the teeth", with_unit(100 * drive.load_friction_share, "%"),
           "", "four spur meshes of 97 % each"},
          {"viscous friction", with_unit(drive.viscous_nm_s_per_rad, "N·m·s/rad"), "",
           "a tenth of the dry friction at the pace of the experiment"},
          {"backlash",
           with_unit(2 * drive.backlash_half_width_rad * 180 / std::numbers::pi, "degrees in all"),
           "", "section IV-C names it and gives no number; usual for small spur gears"}};
}

std::vector<Fact> rig_facts(const Parameters& module) {
  const auto& [arm_m, inertia, stiffness, damping] = module.lever;
  const auto& sensors = module.sensors;
  return {
      {"position loop", with_unit(1e-3 / module.controller.period_s, "kHz"), "section IX",
       "the firmware has current and deflection at up to 1 kHz"},
      {"its gains",
       with_unit(module.controller.proportional_a_per_rad, "A/rad, ") +
           with_unit(module.controller.derivative_a_s_per_rad, "A·s/rad"),
       "", "well damped with the inertia above"},
      {"lever", with_unit(arm_m, "m, ") + with_unit(inertia, "kg·m²"), "",
       "a light handle at a hand's width (figure 8 shows it without a scale)"},
      {"hand and rubber bands", with_unit(stiffness, "N·m/rad, ") + with_unit(damping, "N·m·s/rad"),
       "",
       "an arm of 400 N/m at this lever, as tensed arms are (F. A. Mussa-Ivaldi et al., 1985: some "
       "hundred N/m); figure 8 shows handle, load cell and rubber bands"},
      {"encoders", with_unit(sensors.encoder_step_rad * 180 / std::numbers::pi, "degrees per step"),
       "",
       "section III: two absolute magnetic encoders, before and behind the spring; 14 bits are "
       "usual, the paper does not say"},
      {"encoder noise", with_unit(1e3 * sensors.encoder_noise_rad, "mrad (standard deviation)"), "",
       "a quarter of a step"},
      {"current sensor",
       with_unit(1e3 * sensors.current_step_a, "mA per step, ") +
           with_unit(1e3 * sensors.current_noise_a, "mA noise"),
       "", "a shunt and a 10 to 12 bit converter"},
      {"load cell",
       with_unit(sensors.force_step_n, "N per step, ") +
           with_unit(sensors.force_noise_n, "N noise"),
       "", "section VI: a small load cell; the paper gives no resolution"},
      {"load cell's rate", "50 Hz", "section VI", "logged at 50 Hz with an Arduino"},
      {"telemetry's rate", "500 Hz", "",
       "the paper says only that 1 kHz would be possible in firmware"},
      {"clocks", "apart by 324 ppm and 375 s", "",
       "section VI says that both were synchronised, not how; here searig sync does it"}};
}

std::string words_of(const SineBand& band) {
  return std::to_string(band.count) + " sines of " + with_unit(band.low_hz, "to ") +
         with_unit(band.high_hz, "Hz that add up to ") + with_unit(band.amplitude_rad, "rad");
}

std::vector<Fact> motion_facts(const MotionParameters& motion) {
  return {{"the module's motion", words_of(motion.module), "",
           "section VI: during the module's operation; stays within its ±90 degrees (figure 1)"},
          {"where the hand wants the lever", words_of(motion.hand), "",
           "section VI: applied manually. It holds against the module and gives and takes at "
           "leisure: by section V-A the current is accurate while the deflection grows, which "
           "needs a motor that then drives; reaches torques of 5 to 8 N·m"}};
}

}  // namespace

Parameters nominal_paper_module() {
  Parameters module;
  module.spring.branches = {{6.0, 0.05}, {6.0, 0.5}, {6.0, 5.0}};
  module.spring.recovery_time_s = 1800.0;
  module.drive.efficiency = 1.0;  // what is lost is friction, term by term
  module.drive.stribeck_nm = 0.2;
  module.drive.stribeck_velocity_rad_s = 0.05;
  module.drive.load_friction_share = 0.12;
  module.lever.hand_stiffness_nm_per_rad = 9.0;
  module.motion.hand = {0.5, 0.03, 0.15, 3};
  module.motion.hand_goes_along = 0.0;  // see motion_facts()
  return module;
}

Parameters paper_module(std::uint64_t seed) {
  std::mt19937_64 random(seed + 500);  // the rig takes seeds up to 400 above its own
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Parameters module = nominal_paper_module();
  const double factor = 1.0 + spread * (2.0 * unit(random) - 1.0);
  module.spring.stiffness_nm_per_rad *= factor;
  for (auto& branch : module.spring.branches) branch.stiffness_nm_per_rad *= factor;
  module.spring.worn_at_start = unit(random);
  return module;
}

std::vector<Fact> paper_module_facts() {
  const Parameters module = nominal_paper_module();
  std::vector<Fact> all;
  for (const auto& some : {spring_facts(module.spring), drive_facts(module.drive),
                           rig_facts(module), motion_facts(module.motion)}) {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

}  // namespace searig::estimator::twin
