#include "estimator/physics/single_amplitude.h"

#include <algorithm>
#include <cmath>

namespace searig::estimator {

double scale_of(RelativeTo what, const Model& model) {
  const double efficiency = model.get("drive.motor", "efficiency").value_or(1.0);
  switch (what) {
    case RelativeTo::nothing:
      return 1.0;
    case RelativeTo::stiffness:
      return model.get("spring.linear", "k_nm_per_rad").value_or(1.0);
    case RelativeTo::motor_gain:
      return efficiency * model.get("drive.motor", "torque_constant_nm_per_a").value_or(1.0);
    case RelativeTo::efficiency:
      return efficiency;
  }
  return 1.0;
}

Eigen::VectorXd SingleAmplitude::amplitudes(const Term& term, const Model& model) const {
  return Eigen::VectorXd::Constant(
      1, term.parameters.at(parameters()[0].name) * scale_of(relative_to_, model));
}

std::vector<double> SingleAmplitude::shape(const Term& term) const {
  std::vector<double> out;
  for (std::size_t i = 1; i < parameters().size(); ++i) {
    const auto it = term.parameters.find(parameters()[i].name);
    out.push_back(it != term.parameters.end() ? it->second : parameters()[i].fallback.value());
  }
  return out;
}

Term SingleAmplitude::term(const Eigen::VectorXd& amplitudes, std::span<const double> shape,
                           const Model& model, const Motion&) const {
  Term out{name(), {}};
  out.parameters[parameters()[0].name] = amplitudes[0] / scale_of(relative_to_, model);
  for (std::size_t i = 0; i < shape.size() && i + 1 < parameters().size(); ++i)
    out.parameters[parameters()[i + 1].name] = shape[i];
  return out;
}

Eigen::MatrixXd SingleAmplitude::features(const Motion& motion,
                                          std::span<const double> shape) const {
  return column(motion, shape);
}

std::vector<std::vector<double>> logarithmic_grid(double from, double to, int n) {
  std::vector<std::vector<double>> out;
  for (int i = 0; i < n; ++i)
    out.push_back({from * std::pow(to / from, n > 1 ? double(i) / (n - 1) : 0.0)});
  return out;
}

double rms(const std::vector<double>& x) {
  if (x.empty()) return 0.0;
  return std::sqrt(as_array(x).square().mean());
}

double reach(const std::vector<double>& x) {
  if (x.empty()) return 0.0;
  std::vector<double> magnitude(x.size());
  std::ranges::transform(x, magnitude.begin(), [](double v) { return std::abs(v); });
  const auto at = magnitude.begin() + std::ptrdiff_t(0.995 * double(x.size() - 1));
  std::ranges::nth_element(magnitude, at);
  return *at;
}

}  // namespace searig::estimator
