// Effects on when and how sharply the load cell sees the torque: no torque of their own.
#pragma once

#include "estimator/physics/effect.h"

namespace searig::estimator {

/// parameters()[0] is the one shape parameter, a time in seconds.
class Observation : public Effect {
 public:
  using Effect::Effect;

  bool applies(const Motion& m) const override { return m.size() > 1; }
  Eigen::MatrixXd features(const Motion& m, std::span<const double>) const override {
    return Eigen::MatrixXd(Eigen::Index(m.size()), 0);
  }
  Eigen::VectorXd amplitudes(const Term&, const Model&) const override { return {}; }
  std::size_t free_shape(std::span<const double>) const override { return 1; }
  std::vector<double> shape(const Term& term) const override {
    return {term.parameters.at(parameters()[0].name)};
  }
  Term term(const Eigen::VectorXd&, std::span<const double> shape, const Model&,
            const Motion&) const override {
    return {name(), {{parameters()[0].name, shape[0]}}};
  }

  /// The signal as seen: t and x on the module's samples, the result on the same samples.
  virtual Eigen::VectorXd seen(const std::vector<double>& t, const Eigen::VectorXd& x,
                               double seconds) const = 0;
};

}  // namespace searig::estimator
