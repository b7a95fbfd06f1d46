#include "estimator/twin/rubber_spring.h"

#include <cmath>

namespace searig::estimator::twin {

RubberSpring::RubberSpring(const SpringParameters& parameters)
    : parameters_(parameters),
      relaxed_rad_(parameters.branches.size(), 0.0),
      worn_(parameters.worn_at_start) {}

double RubberSpring::softness() const {
  return 1.0 - parameters_.softening_share * worn_;
}

double RubberSpring::stiffness_nm_per_rad() const {
  return softness() * parameters_.stiffness_nm_per_rad;
}

double RubberSpring::torque_nm(double deflection_rad) const {
  double sum = parameters_.stiffness_nm_per_rad * deflection_rad;
  for (std::size_t i = 0; i < relaxed_rad_.size(); ++i) {
    sum += parameters_.branches[i].stiffness_nm_per_rad * (deflection_rad - relaxed_rad_[i]);
  }
  return softness() * sum;
}

double RubberSpring::rest_deflection_rad() const {
  // 0 = k*theta + sum_i k_i*(theta - x_i)
  double pull = 0.0, stiffness = parameters_.stiffness_nm_per_rad;
  for (std::size_t i = 0; i < relaxed_rad_.size(); ++i) {
    pull += parameters_.branches[i].stiffness_nm_per_rad * relaxed_rad_[i];
    stiffness += parameters_.branches[i].stiffness_nm_per_rad;
  }
  return pull / stiffness;
}

// Exact for a deflection and a power that hold over the step, so any step size is stable.
void RubberSpring::step(double deflection_rad, double dt_s) {
  const double work_j = std::abs(torque_nm(deflection_rad) * (deflection_rad - deflection_rad_));
  worn_ += (1.0 - worn_) * -std::expm1(-work_j / parameters_.softening_work_j);
  worn_ *= std::exp(-dt_s / parameters_.recovery_time_s);
  deflection_rad_ = deflection_rad;
  for (std::size_t i = 0; i < relaxed_rad_.size(); ++i) {
    relaxed_rad_[i] +=
        (deflection_rad - relaxed_rad_[i]) * -std::expm1(-dt_s / parameters_.branches[i].time_s);
  }
}

}  // namespace searig::estimator::twin
