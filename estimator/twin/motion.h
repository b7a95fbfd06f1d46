// What the module is told to do and what the hand does to it, as functions of time.
#pragma once

#include <cstdint>
#include <vector>

#include "estimator/twin/parameters.h"

namespace searig::estimator::twin {

/// A sum of sines that starts at rest: smooth, never repeating within a recording, and known at any
/// time without stepping.
class SmoothMotion {
 public:
  /// Phases and the exact frequencies within the band follow from the seed.
  SmoothMotion(const SineBand& band, std::uint64_t seed);

  double at(double t_s) const;

 private:
  struct Sine {
    double amplitude, rad_s, phase;
  };
  std::vector<Sine> sines_;
};

/// The paper's experiment: the module follows a motion while a hand at the lever pulls against it.
class MotionProgram {
 public:
  MotionProgram(const MotionParameters& parameters, std::uint64_t seed);

  double commanded_angle_rad(double t_s) const;
  /// The angle to which the hand wants the lever.
  double hand_angle_rad(double t_s) const;

 private:
  SmoothMotion module_;
  SmoothMotion pull_;
  double hand_goes_along_;
};

}  // namespace searig::estimator::twin
