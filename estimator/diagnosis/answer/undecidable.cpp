#include "estimator/diagnosis/answer/undecidable.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "estimator/diagnosis/fit/regression.h"
#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

constexpr double seen_gain = 30.0;   // what a term must bring to be asserted
constexpr double visible_rho = 0.6;  // effects this large, over the noise, should be seen
constexpr double alike = 0.98;       // squared correlation beyond which two effects are one

struct Visible {
  const Effect* effect;
  Eigen::MatrixXd columns;  // whitened
  double least_rho;         // over the noise, to be asserted
  double least_share;       // the same over the torque's rms
};

/// Share of the candidate that the fixed columns do not span, at the amplitudes that they hide
/// best: a weight may hang at any phase.
double least_independence(const Projection& projection, const Eigen::MatrixXd& columns) {
  const Eigen::VectorXd scale = columns.colwise().norm().cwiseMax(1e-300).cwiseInverse();
  const Eigen::MatrixXd all = columns * scale.asDiagonal(), free = projection.free_part(all);
  Eigen::MatrixXd norm = all.transpose() * all;
  norm.diagonal().array() += 1e-9;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> shares(free.transpose() * free,
                                                                         norm);
  return std::sqrt(std::max(0.0, shares.eigenvalues()[0]));
}

/// The shape in the middle of the grid stands for the effect.
std::vector<Visible> candidates(const Bench& bench, const Hypothesis& hypothesis,
                                const Projection& projection) {
  std::vector<Visible> out;
  const Experiment& e = bench.experiment();
  for (const Effect* effect : catalogue()) {
    if (std::ranges::any_of(hypothesis, [&](const Piece& p) { return p.effect == effect; }))
      continue;
    if (!effect->applies(e.motion)) continue;
    const auto grid = effect->shape_grid(e.motion);
    if (grid.empty()) continue;
    const Piece piece{effect, grid[grid.size() / 2], nullptr};
    const Eigen::MatrixXd columns = bench.screening_columns(piece);
    if (!(columns.norm() > 0)) continue;
    const double free = least_independence(projection, columns);
    const double used = double(std::max<Eigen::Index>(1, bench.whitening().used_rows()));
    const double rho = std::sqrt(seen_gain / used) / std::max(free, 1e-9);
    const double sd = effect->path() == Path::drive ? bench.whitening().drive().sd
                                                    : bench.whitening().loadcell().sd;
    out.push_back({effect, columns, rho, rho * sd / e.torque_rms});
  }
  return out;
}

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g %%", 100.0 * share);
  return text;
}

std::string why_not_seen(const Visible& c) {
  const std::string taken = std::string(c.columns.cols() > 1 ? " at its least visible phase" : "") +
                            ": the fitted terms and the clocks take up the rest";
  if (c.least_share > 1.0) return "under this motion it cannot be seen, however large" + taken;
  return "under this motion it would be asserted only above " + percent(c.least_share) +
         " of the torque" + taken;
}

/// Squared correlation of what two effects add beyond the fixed columns.
double correlation(const Projection& projection, const Visible& a, const Visible& b,
                   const Fit& fit) {
  const double alone = projection.gain(a.columns).independence * a.columns.norm();
  if (!(alone > 0)) return 1.0;
  Eigen::MatrixXd both(fit.free_columns.rows(), fit.free_columns.cols() + b.columns.cols());
  both << fit.free_columns, b.columns;
  const double beside =
      Projection(both, fit.free_right).gain(a.columns).independence * a.columns.norm();
  return 1.0 - std::pow(beside / alone, 2);
}

}  // namespace

std::vector<Undecidable> undecidable(const Bench& bench, const Hypothesis& hypothesis) {
  const Fit fit = bench.fit(hypothesis);
  const Projection projection(fit.free_columns, fit.free_right);
  const auto all = candidates(bench, hypothesis, projection);
  std::vector<Undecidable> out;
  std::vector<const Visible*> visible;
  for (const auto& c : all) {
    if (c.least_rho <= visible_rho) {
      visible.push_back(&c);
      continue;
    }
    out.push_back({{c.effect->name()}, why_not_seen(c), c.effect->about().separated_by});
  }
  for (std::size_t i = 0; i < visible.size(); ++i)
    for (std::size_t j = i + 1; j < visible.size(); ++j)
      if (visible[i]->effect->path() == visible[j]->effect->path() &&
          correlation(projection, *visible[i], *visible[j], fit) > alike)
        out.push_back({{visible[i]->effect->name(), visible[j]->effect->name()},
                       "under this motion they look alike once the numbers are refitted",
                       visible[i]->effect->about().separated_by});
  return out;
}

}  // namespace searig::estimator
