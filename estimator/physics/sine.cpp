#include "estimator/physics/sine.h"

#include <cmath>

#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {

Eigen::VectorXd Sine::amplitudes(const Term& term, const Model&) const {
  const double torque = term.parameters.at("torque_nm");
  const double phase = term.parameters.at("phase_rad");
  return Eigen::Vector2d(torque * std::cos(phase), torque * std::sin(phase));
}

Term Sine::term(const Eigen::VectorXd& a, std::span<const double>, const Model&,
                const Motion&) const {
  return {name(), {{"torque_nm", std::hypot(a[0], a[1])}, {"phase_rad", std::atan2(a[1], a[0])}}};
}

Eigen::MatrixXd Sine::columns(const std::vector<double>& angle, double cycles) {
  const Eigen::ArrayXd x = cycles * as_array(angle);
  Eigen::MatrixXd out(x.size(), 2);
  out.col(0) = -x.sin();
  out.col(1) = -x.cos();
  return out;
}

}  // namespace searig::estimator
