#include "estimator/diagnosis/parameters.h"

#include <Eigen/Dense>
#include <cmath>

namespace searig::estimator {
namespace {

struct ShapePlace {
  std::size_t piece, value;
};

std::vector<ShapePlace> shape_places(const Hypothesis& hypothesis) {
  std::vector<ShapePlace> out;
  for (std::size_t p = 0; p < hypothesis.size(); ++p)
    if (hypothesis[p].effect)
      for (std::size_t v = 0; v < hypothesis[p].effect->free_shape(hypothesis[p].shape); ++v)
        out.push_back({p, v});
  return out;
}

double step_of(double value) { return 1e-4 * std::max(std::abs(value), 1e-3); }

Hypothesis nudged(Hypothesis h, const ShapePlace& at, double by) {
  h[at.piece].shape[at.value] += by;
  return h;
}

/// Columns of the joint problem: amplitudes, nuisances, then one per shape value.
Eigen::MatrixXd jacobian(const Bench& bench, const Hypothesis& hypothesis, const Fit& fit,
                         const std::vector<ShapePlace>& places) {
  Eigen::MatrixXd out(fit.columns.rows(), fit.columns.cols() + Eigen::Index(places.size()));
  out.leftCols(fit.columns.cols()) = fit.columns;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const double h = step_of(hypothesis[places[i].piece].shape[places[i].value]);
    const Eigen::MatrixXd up = bench.fit(nudged(hypothesis, places[i], h)).columns;
    const Eigen::MatrixXd down = bench.fit(nudged(hypothesis, places[i], -h)).columns;
    out.col(fit.columns.cols() + Eigen::Index(i)) =
        (up - down) * fit.solution.coefficients / (2.0 * h);
  }
  return out;
}

Eigen::MatrixXd covariance_of(const Eigen::MatrixXd& j) {
  Eigen::VectorXd scale = j.colwise().norm();
  scale = (scale.array() > 0).select(scale.cwiseInverse(), 0.0);
  Eigen::MatrixXd normal = scale.asDiagonal() * (j.transpose() * j) * scale.asDiagonal();
  normal.diagonal().array() += 1e-9;
  const Eigen::MatrixXd inverse =
      normal.ldlt().solve(Eigen::MatrixXd::Identity(normal.rows(), normal.cols()));
  return scale.asDiagonal() * inverse * scale.asDiagonal();
}

Eigen::VectorXd flat(const Model& model) {
  std::vector<double> out;
  for (const auto& term : model.terms)
    for (const auto& [name, value] : term.parameters) out.push_back(value);
  return Eigen::Map<Eigen::VectorXd>(out.data(), Eigen::Index(out.size()));
}

}  // namespace

Model model_of(const Bench& bench, const Hypothesis& hypothesis, const Fit& layout,
               const Eigen::VectorXd& coefficients, const Model& given) {
  Model out;
  if (const Term* motor = given.find("drive.motor")) out.terms.push_back(*motor);
  const auto put = [&](bool leading) {  // k and the motor's gain first: others are relative to them
    for (std::size_t i = 0; i < hypothesis.size(); ++i) {
      if (!hypothesis[i].effect) continue;
      const std::string& name = hypothesis[i].effect->name();
      if ((name == "spring.linear" || name == "drive.motor") != leading) continue;
      const Eigen::VectorXd amplitudes = coefficients.segment(layout.first[i], layout.count[i]);
      Term term = hypothesis[i].effect->term(amplitudes, hypothesis[i].shape, out,
                                             bench.experiment().motion);
      if (Term* known = out.find(name))
        *known = std::move(term);
      else
        out.terms.push_back(std::move(term));
    }
  };
  put(true);
  put(false);
  return out;
}

std::vector<ParameterEstimate> estimate_parameters(const Bench& bench, const Hypothesis& hypothesis,
                                                   const Fit& fit, const Model& given) {
  const auto places = shape_places(hypothesis);
  const Eigen::MatrixXd covariance = covariance_of(jacobian(bench, hypothesis, fit, places));
  const Eigen::VectorXd& x = fit.solution.coefficients;
  const Model model = model_of(bench, hypothesis, fit, x, given);
  const Eigen::VectorXd value = flat(model);
  Eigen::MatrixXd gradient(value.size(), covariance.rows());
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    const bool is_shape = i >= x.size();
    Eigen::VectorXd moved = x;
    Hypothesis shaped = hypothesis;
    double h;
    if (is_shape) {
      const auto& at = places[std::size_t(i - x.size())];
      h = step_of(hypothesis[at.piece].shape[at.value]);
      shaped = nudged(hypothesis, at, h);
    } else {
      h = 1e-4 * std::max(std::sqrt(std::max(0.0, covariance(i, i))), 1e-12);
      moved[i] += h;
    }
    gradient.col(i) = (flat(model_of(bench, shaped, fit, moved, given)) - value) / h;
  }
  std::vector<ParameterEstimate> out;
  Eigen::Index row = 0;
  for (const auto& term : model.terms)
    for (const auto& [name, number] : term.parameters) {
      const Eigen::VectorXd g = gradient.row(row++);
      const double sd = std::sqrt(std::max(0.0, g.dot(covariance * g)));
      out.push_back({term.effect, name, number, number - 1.96 * sd, number + 1.96 * sd});
    }
  return out;
}

}  // namespace searig::estimator
