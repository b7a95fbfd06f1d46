#include "estimator/evaluation/regime.h"

#include <algorithm>

namespace searig::estimator {
namespace {

constexpr double moving_rad_s = 0.03;  // the contract's, as in diagnosis/experiment.h
constexpr double reversing_for_s = 0.1;
constexpr double same = 1e-3;  // of the largest current
constexpr double limited_for_s = 0.05;

}  // namespace

/// A current that is free passes its peak; a limit holds it there.
bool RegimeFinder::at_limit(double t_s, double current_a) {
  const double size = std::abs(current_a);
  if (size > largest_a_ * (1.0 + same)) at_largest_since_s_ = t_s;
  largest_a_ = std::max(largest_a_, size);
  if (!(size > 0.0) || size < largest_a_ * (1.0 - same)) {
    at_largest_since_s_ = std::numeric_limits<double>::infinity();
    return false;
  }
  at_largest_since_s_ = std::min(at_largest_since_s_, t_s);
  return t_s >= at_largest_since_s_ + limited_for_s;
}

Regime RegimeFinder::take(double t_s, double velocity_rad_s, double torque_nm, double current_a) {
  const bool limited = at_limit(t_s, current_a);
  const bool moves = std::abs(velocity_rad_s) >= moving_rad_s;
  if (moves) {
    const double direction = velocity_rad_s > 0.0 ? 1.0 : -1.0;
    if (direction_ * direction < 0.0) reversed_s_ = t_s;
    direction_ = direction;
  }
  if (limited) return Regime::saturated;
  if (!moves) return Regime::sticking;
  if (t_s < reversed_s_ + reversing_for_s) return Regime::reversing;
  return velocity_rad_s * torque_nm >= 0.0 ? Regime::driving : Regime::back_driven;
}

}  // namespace searig::estimator
