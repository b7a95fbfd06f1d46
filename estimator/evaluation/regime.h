// What the drive train is doing: what a residual has to be looked at beside.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace searig::estimator {

enum class Regime : std::size_t { sticking, driving, back_driven, reversing, saturated };

inline constexpr std::array<const char*, 5> regime_names{"sticking", "driving", "back-driven",
                                                         "reversing", "saturated"};

/// Tells the regime sample by sample.
/// sticking: the input is slower than 0.03 rad/s, where the current says nothing about torque.
/// reversing: it moves the other way since less than 0.1 s.
/// driving, back_driven: the train gives work to the spring, or takes it.
/// saturated: the current has stood at the largest value that it ever had for 50 ms.
class RegimeFinder {
 public:
  /// velocity_rad_s of the input; torque_nm of the spring. t_s rises.
  Regime take(double t_s, double velocity_rad_s, double torque_nm, double current_a);

 private:
  bool at_limit(double t_s, double current_a);

  double direction_ = 0.0;  ///< in which it moved last
  double reversed_s_ = -std::numeric_limits<double>::infinity();
  double largest_a_ = 0.0;
  double at_largest_since_s_ = std::numeric_limits<double>::infinity();
};

}  // namespace searig::estimator
