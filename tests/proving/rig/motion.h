#pragma once

#include <string>
#include <vector>

#include "tests/proving/random.h"

namespace searig::proving {

/// What motor and hand are asked to do, before the trajectory generator rounds it off.
struct Motion {
  static constexpr double rate_hz = 250.0;
  std::vector<double> motor_rad;
  std::vector<double> hand_rad;

  static double at(const std::vector<double>& samples, double t_s);
};

struct MotionPlan {
  std::vector<std::string> segments;  ///< names below, run one after another
  std::vector<double> shares;         ///< of the time, one per segment; they sum to one
  double motor_amplitude_rad = 0.5;
  double hand_amplitude_rad = 0.3;
  double pace = 1.0;          ///< multiplies every frequency
  double bias_rad = 0.0;      ///< motor minus hand: keeps the spring loaded on one side
  double generator_hz = 3.0;  ///< of the trajectory generator that rounds every edge off
};

/// Segments: multisine, triangles, staircase, chirp, hand, growing, rest, slow_triangle, sine,
/// constant_speed, slow_sweep, fast_burst, small, steps.
Motion plan_motion(const MotionPlan& plan, double duration_s, Random random);

}  // namespace searig::proving
