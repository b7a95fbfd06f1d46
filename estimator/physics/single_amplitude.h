// The common case: one torque column times one number of the model file.
#pragma once

#include "estimator/physics/effect.h"

namespace searig::estimator {

/// What the parameter is relative to: amplitude = parameter * scale(model).
enum class RelativeTo { nothing, stiffness, motor_gain, efficiency };

double scale_of(RelativeTo what, const Model& model);

/// parameters()[0] is the amplitude's parameter, the following ones are the shape's, in order.
class SingleAmplitude : public Effect {
 public:
  Eigen::VectorXd amplitudes(const Term& term, const Model& model) const override;
  std::vector<double> shape(const Term& term) const override;
  Term term(const Eigen::VectorXd& amplitudes, std::span<const double> shape, const Model& model,
            const Motion& motion) const override;
  Eigen::MatrixXd features(const Motion& motion, std::span<const double> shape) const override;

 protected:
  SingleAmplitude(Description about, std::vector<Parameter> parameters,
                  RelativeTo relative_to = RelativeTo::nothing)
      : Effect(std::move(about), std::move(parameters)), relative_to_(relative_to) {}

  /// The torque per unit amplitude, one value per sample.
  virtual Eigen::VectorXd column(const Motion& motion, std::span<const double> shape) const = 0;

 private:
  RelativeTo relative_to_;
};

inline Eigen::Map<const Eigen::ArrayXd> as_array(const std::vector<double>& x) {
  return {x.data(), static_cast<Eigen::Index>(x.size())};
}

/// n values from `from` to `to`, evenly spaced in their logarithm, as one-parameter shapes.
std::vector<std::vector<double>> logarithmic_grid(double from, double to, int n);

double rms(const std::vector<double>& x);

/// The largest magnitude that all but 0.5 % of the samples stay under.
double reach(const std::vector<double>& x);

}  // namespace searig::estimator
