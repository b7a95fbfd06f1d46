#include "estimator/diagnosis/fit/parameters.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

/// Nature's form of an effect is not the catalogue's; on the proving ground, whose forms are
/// others, intervals have to be this much wider to cover the truth as often as they say.
constexpr double form_margin = 1.3;

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

double step_of(double value) {
  return 1e-4 * std::max(std::abs(value), 1e-3);
}

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
    const Eigen::MatrixXd up = bench.whitened(nudged(hypothesis, places[i], h));
    const Eigen::MatrixXd down = bench.whitened(nudged(hypothesis, places[i], -h));
    out.col(fit.columns.cols() + Eigen::Index(i)) =
        (up - down) * fit.solution.coefficients / (2.0 * h);
  }
  return out;
}

/// The larger of two covariances: what white residuals imply, and what the scatter of whole blocks
/// implies (the cluster sandwich of K.-Y. Liang, S. Zeger, Biometrika 73, 1986), which also sees
/// what the model leaves unexplained. Returned as {H^-1, H^-1 B H^-1}.
struct Covariances {
  Eigen::MatrixXd model, blocks;
  double quantile;  ///< of Student's t for the number of blocks, at 97.5 %
};

Covariances covariances_of(const Eigen::MatrixXd& j, const Eigen::VectorXd& residual,
                           const std::vector<int>& block) {
  Eigen::VectorXd scale = j.colwise().norm();
  scale = (scale.array() > 0).select(scale.cwiseInverse(), 0.0);
  Eigen::MatrixXd normal = scale.asDiagonal() * (j.transpose() * j) * scale.asDiagonal();
  normal.diagonal().array() += 1e-9;
  const Eigen::MatrixXd inverse =
      normal.ldlt().solve(Eigen::MatrixXd::Identity(normal.rows(), normal.cols()));
  const int blocks = *std::ranges::max_element(block) + 1;
  Eigen::MatrixXd score = Eigen::MatrixXd::Zero(j.cols(), blocks);
  for (Eigen::Index i = 0; i < j.rows(); ++i)
    if (block[std::size_t(i)] >= 0) score.col(block[std::size_t(i)]) += j.row(i) * residual[i];
  const Eigen::MatrixXd bread = scale.asDiagonal() * inverse * scale.asDiagonal();
  const Eigen::MatrixXd lever = bread * score;
  const double t[] = {12.7, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26, 2.23};
  const int freedom = std::max(1, blocks - 1);
  return {bread, lever * lever.transpose() * (double(blocks) / freedom),
          freedom <= 10 ? t[freedom - 1] : 2.1};
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
  const auto [covariance, between_blocks, quantile] = covariances_of(
      jacobian(bench, hypothesis, fit, places), fit.solution.residual, bench.blocks());
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
      double half =
          form_margin * std::max(1.96 * std::sqrt(std::max(0.0, g.dot(covariance * g))),
                                 quantile * std::sqrt(std::max(0.0, g.dot(between_blocks * g))));
      const Effect* effect = find_effect(term.effect);
      if (effect && effect->path() == Path::observation)  // what the clock map leaves open adds
        half = std::hypot(half, 1.96 * bench.experiment().clock_sd_s);
      out.push_back({term.effect, name, number, number - half, number + half});
    }
  return out;
}

}  // namespace searig::estimator
