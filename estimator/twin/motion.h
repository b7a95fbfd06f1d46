// What the module is told to do and what the hand does to it, as functions of time.
#pragma once

#include <cstdint>
#include <vector>

namespace searig::estimator::twin {

/// A sum of sines that starts at rest: smooth, never repeating within a recording, and known at any
/// time without stepping.
class SmoothMotion {
 public:
  /// `count` sines with frequencies spread over [low_hz, high_hz]; their amplitudes add up to
  /// `amplitude`. Phases and the exact frequencies follow from the seed.
  SmoothMotion(double amplitude, double low_hz, double high_hz, int count, std::uint64_t seed);

  double at(double t_s) const;

 private:
  struct Sine {
    double amplitude, rad_s, phase;
  };
  std::vector<Sine> sines_;
};

/// The paper's experiment: the module follows a motion while a hand at the lever goes along with it
/// and pulls against it.
class MotionProgram {
 public:
  explicit MotionProgram(std::uint64_t seed);

  double commanded_angle_rad(double t_s) const;
  /// The angle to which the hand wants the lever.
  double hand_angle_rad(double t_s) const;

 private:
  SmoothMotion module_;
  SmoothMotion pull_;
};

}  // namespace searig::estimator::twin
