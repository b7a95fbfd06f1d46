#include "estimator/twin/motion.h"

#include <cmath>
#include <numbers>
#include <random>

namespace searig::estimator::twin {
namespace {

/// Rises from 0 to 1 within the first two seconds, so that nothing starts with a jerk.
double soft_start(double t_s) {
  constexpr double rise_s = 2.0;
  if (t_s <= 0.0) return 0.0;
  if (t_s >= rise_s) return 1.0;
  return 0.5 - 0.5 * std::cos(std::numbers::pi * t_s / rise_s);
}

}  // namespace

SmoothMotion::SmoothMotion(const SineBand& band, std::uint64_t seed) {
  const auto& [amplitude, low_hz, high_hz, count] = band;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < count; ++i) {
    const double share = (i + 0.2 + 0.6 * unit(random)) / count;
    const double hz = low_hz * std::pow(high_hz / low_hz, share);
    sines_.push_back(
        {amplitude / count, 2.0 * std::numbers::pi * hz, 2.0 * std::numbers::pi * unit(random)});
  }
}

double SmoothMotion::at(double t_s) const {
  double sum = 0.0;
  for (const auto& sine : sines_) sum += sine.amplitude * std::sin(sine.rad_s * t_s + sine.phase);
  return soft_start(t_s) * sum;
}

MotionProgram::MotionProgram(const MotionParameters& parameters, std::uint64_t seed)
    : module_(parameters.module, seed),
      pull_(parameters.hand, seed + 1),
      hand_goes_along_(parameters.hand_goes_along) {}

double MotionProgram::commanded_angle_rad(double t_s) const {
  return module_.at(t_s);
}

double MotionProgram::hand_angle_rad(double t_s) const {
  return hand_goes_along_ * module_.at(t_s) + pull_.at(t_s);
}

}  // namespace searig::estimator::twin
