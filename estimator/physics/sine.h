// - torque*sin(cycles*angle + phase): what ripple and gravity have in common.
#pragma once

#include "estimator/physics/effect.h"

namespace searig::estimator {

/// Two amplitudes, torque*cos(phase) and torque*sin(phase), so that the phase needs no search.
class Sine : public Effect {
 public:
  using Effect::Effect;

  Eigen::VectorXd amplitudes(const Term& term, const Model& model) const override;
  Term term(const Eigen::VectorXd& amplitudes, std::span<const double> shape, const Model& model,
            const Motion& motion) const override;

 protected:
  static Eigen::MatrixXd columns(const std::vector<double>& angle, double cycles);
};

}  // namespace searig::estimator
