// The numbers of a simulated module and its rig.
//
// The defaults are the demo's module: of the paper's kind, with a drive whose owner can know it
// exactly, so that a first look shows the method and not its limits. The paper's own module, with
// what the paper says of it, is paper_module() in paper_module.h.
//
// "Paper" is D. Rollinson et al., "Online Calibration of a Compact Series Elastic Actuator";
// "chosen" is a value of the right size. Everything on the drive side is reflected to the output of
// the gear train.
#pragma once

#include <limits>
#include <numbers>
#include <vector>

namespace searig::estimator::twin {

/// A spring and a dashpot in a row, beside the spring that stays: what makes rubber relax.
struct MaxwellBranch {
  double stiffness_nm_per_rad;
  double time_s;
};

/// Rubber sheared between two plates, which softens as it is worked.
struct SpringParameters {
  double stiffness_nm_per_rad = 40.0;  ///< at rest, unworn; chosen: 6 N*m at 8.6 degrees
  std::vector<MaxwellBranch> branches = {{2.0, 0.15}};  ///< chosen: 5 % of the whole
  double softening_share = 0.25;   ///< paper, figure 3: "changed by about 25 %" (Mullins effect)
  double softening_work_j = 25.0;  ///< chosen: work done at which 63 % of the softening is there
  double recovery_time_s = std::numeric_limits<double>::infinity();  ///< at rest; none
  double worn_at_start = 0.0;  ///< share of the softening that is there already
};

/// Brushless motor and spur gears.
struct DriveParameters {
  double gear_ratio = 349.0;               ///< paper, section III
  double torque_constant_nm_per_a = 2.6;   ///< chosen: with the efficiency 6.8 N*m at full current
  double efficiency = 0.75;                ///< of every torque, whichever way it goes; chosen
  double inertia_kg_m2 = 0.012;            ///< chosen: a 1e-7 kg*m^2 rotor times 349^2
  double coulomb_nm = 0.4;                 ///< chosen; the paper shows the sticking, not the number
  double stribeck_nm = 0.0;                ///< what sticking adds to it; none
  double stribeck_velocity_rad_s = 0.05;   ///< where that is down to 37 %
  double load_friction_share = 0.0;        ///< friction per torque through the teeth; none
  double viscous_nm_s_per_rad = 0.15;      ///< chosen
  double backlash_half_width_rad = 0.004;  ///< chosen: 0.46 degrees of play in all
  double current_limit_a = 3.5;            ///< chosen: "over 6 N-m of torque", figure 1
};

/// The module's own position loop, on the motor's side of the gear train.
struct ControllerParameters {
  double period_s = 0.001;               ///< paper, section IX: "at up to 1 kHz"
  double proportional_a_per_rad = 80.0;  ///< chosen
  double derivative_a_s_per_rad = 1.5;   ///< chosen: well damped with the inertia above
};

/// Lever, handle and the hand at it (paper, figure 8).
struct LeverParameters {
  double arm_m = 0.15;                      ///< chosen
  double inertia_kg_m2 = 0.0012;            ///< chosen: a light handle on this arm
  double hand_stiffness_nm_per_rad = 40.0;  ///< chosen: a firm wrist and the rubber bands
  double hand_damping_nm_s_per_rad = 0.4;   ///< chosen
};

struct SensorParameters {
  double encoder_step_rad = 2.0 * std::numbers::pi / 16384;  ///< 14-bit absolute magnetic encoders
  double encoder_noise_rad = 1e-4;                           ///< chosen
  double current_noise_a = 0.02;                             ///< chosen
  double current_step_a = 0.005;                             ///< chosen
  double force_noise_n = 0.05;                               ///< chosen
  double force_step_n = 0.01;                                ///< chosen: what the sketch prints
};

/// Sines with frequencies spread over a band, whose amplitudes add up.
struct SineBand {
  double amplitude_rad;
  double low_hz, high_hz;
  int count;
};

/// What the module is told to do, and to which angle the hand wants the lever.
struct MotionParameters {
  SineBand module = {0.9, 0.05, 0.45, 4};  ///< chosen; within the paper's +-90 degrees
  SineBand hand = {0.55, 0.12, 1.1, 5};    ///< chosen
  double hand_goes_along = 1.0;            ///< share of the module's motion that it follows; chosen
};

struct Parameters {
  MotionParameters motion;
  SpringParameters spring;
  DriveParameters drive;
  ControllerParameters controller;
  LeverParameters lever;
  SensorParameters sensors;
};

}  // namespace searig::estimator::twin
