// The rubber between input and output plate.
#pragma once

#include <vector>

#include "estimator/twin/parameters.h"

namespace searig::estimator::twin {

/// A generalised Maxwell solid that softens as it is worked and recovers all the while, which shows
/// at rest.
///
///   T = s * (k*theta + sum_i k_i*(theta - x_i)),   dx_i/dt = (theta - x_i)/tau_i
///   s = 1 - share*d,   dd = (1 - d) |T dtheta|/W0 - d dt/tau_r                 (Mullins effect)
class RubberSpring {
 public:
  explicit RubberSpring(const SpringParameters& parameters);

  double torque_nm(double deflection_rad) const;
  /// The deflection at which the spring pushes on neither plate.
  double rest_deflection_rad() const;
  /// What k is now, softened: the stiffness at rest.
  double stiffness_nm_per_rad() const;
  /// How much of the softening is there, 0 .. 1.
  double worn() const { return worn_; }
  void step(double deflection_rad, double dt_s);

 private:
  double softness() const;

  SpringParameters parameters_;
  std::vector<double> relaxed_rad_;  ///< x_i
  double deflection_rad_ = 0.0;
  double worn_;  ///< d
};

}  // namespace searig::estimator::twin
