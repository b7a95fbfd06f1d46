// The fitting half of Bench: noise, and sets of terms under it.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/fit/bench.h"
#include "estimator/diagnosis/fit/free_scale.h"

namespace searig::estimator {
namespace {

/// The hypothesis's motor; its size where it has none.
std::size_t motor_of(const Hypothesis& hypothesis) {
  const auto at = std::ranges::find_if(
      hypothesis, [](const Piece& p) { return p.effect && p.effect->name() == "drive.motor"; });
  return std::size_t(at - hypothesis.begin());
}

}  // namespace

/// 0 = drive - spring holds at any scale, zero included, and cleaners that explain the load cell by
/// themselves would let go of it. The motor keeps its gain: its column moves to the right side.
void Bench::hold_scale(const Hypothesis& hypothesis, const std::vector<Eigen::Index>& first,
                       Eigen::Index own, Eigen::MatrixXd& columns, Eigen::VectorXd& right) {
  const std::size_t motor = motor_of(hypothesis);
  if (!experiment_.has_spring() || motor == hypothesis.size()) return;
  gain_ = whitening_ ? fit(hypothesis).amplitudes(motor)[0]
                     : solve(columns.leftCols(own), right).coefficients[first[motor]];
  right -= gain_ * columns.col(first[motor]);
  columns.col(first[motor]).setZero();
}

void Bench::learn_noise(const Hypothesis& hypothesis, const std::vector<Piece>& cleaners) {
  if (raw_nuisance_.size() == 0) raw_nuisance_ = nuisances();
  Fit layout;
  const Eigen::MatrixXd own = assemble(hypothesis, layout, false);
  Eigen::Index total = own.cols();
  for (const auto& piece : cleaners) total += raw_columns(piece, 0.0, 0.0).cols();
  Eigen::MatrixXd all(total_rows(), total);
  all.leftCols(own.cols()) = own;
  Eigen::Index at = own.cols();
  for (const auto& piece : cleaners) {
    const Eigen::MatrixXd& part = raw_columns(piece, 0.0, 0.0);
    all.middleCols(at, part.cols()) = part;
    at += part.cols();
  }
  Eigen::VectorXd right = Eigen::VectorXd::Zero(total_rows());
  right.head(experiment_.rows()) = experiment_.measured;
  for (Eigen::Index i = 0; i < experiment_.rows(); ++i)
    if (!experiment_.usable[std::size_t(i)]) all.row(i).setZero(), right[i] = 0.0;
  hold_scale(hypothesis, layout.first, own.cols(), all, right);
  Eigen::VectorXd norm = all.colwise().norm();
  norm = (norm.array() > 0).select(norm, 1.0);
  all *= norm.cwiseInverse().asDiagonal();
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(total, total);
  normal.selfadjointView<Eigen::Lower>().rankUpdate(all.transpose());
  normal.diagonal().array() += 1e-7;  // the cells of one axis sum to another's
  const Eigen::VectorXd x =
      normal.selfadjointView<Eigen::Lower>().ldlt().solve(all.transpose() * right);
  const Eigen::VectorXd residual = right - all * x;
  set_noise(Whitening(experiment_, residual.head(experiment_.rows()), method_.noise_has_memory));
}

Eigen::MatrixXd Bench::assemble(const Hypothesis& hypothesis, Fit& fit, bool whitened) const {
  // Only here, where no column is held by reference yet.
  if (raw_cache_.size() > 1500) raw_cache_.clear();
  if (cache_.size() > 1500) cache_.clear();
  const Seen seen = seen_by(hypothesis);
  const auto tied = [](const Piece& p) { return p.effect && !p.effect->tied_to().empty(); };
  std::vector<const Eigen::MatrixXd*> parts;
  Eigen::Index total = 0;
  for (const auto& piece : hypothesis) {
    parts.push_back(whitened ? &columns(piece, seen.delay_s, seen.lag_s)
                             : &raw_columns(piece, seen.delay_s, seen.lag_s));
    fit.first.push_back(total);
    fit.count.push_back(parts.back()->cols());
    if (!tied(piece)) total += parts.back()->cols();
  }
  const Eigen::MatrixXd& nuisance = whitened ? nuisance_ : raw_nuisance_;
  Eigen::MatrixXd out(total_rows(), total + nuisance.cols());
  for (std::size_t i = 0; i < hypothesis.size(); ++i)
    if (!tied(hypothesis[i])) out.middleCols(fit.first[i], fit.count[i]) = *parts[i];
  for (std::size_t i = 0; i < hypothesis.size(); ++i)
    for (std::size_t j = 0; tied(hypothesis[i]) && j < hypothesis.size(); ++j)
      if (hypothesis[j].effect && hypothesis[j].effect->name() == hypothesis[i].effect->tied_to()) {
        fit.first[i] = fit.first[j];
        out.middleCols(fit.first[j], fit.count[j]) += *parts[i];
      }
  out.rightCols(nuisance.cols()) = nuisance;
  return out;
}

Eigen::MatrixXd Bench::whitened(const Hypothesis& hypothesis) const {
  Fit ignored;
  return assemble(hypothesis, ignored, true);
}

/// Solves for the free columns, and leaves them linearised.
Solution Bench::solve_scaled(const Hypothesis& hypothesis, Fit& fit) const {
  const std::size_t motor = motor_of(hypothesis);
  if (gain_ <= 0.0 || motor == hypothesis.size()) return solve(fit.free_columns, fit.free_right);
  const Experiment& e = experiment_;
  return solve(fit.free_columns, fit.free_right,
               {fit.first[motor], e.loadcell_rows(), e.drive_rows(), gain_});
}

Fit Bench::unbounded_fit(const Hypothesis& hypothesis) const {
  Fit out;
  out.columns = out.free_columns = assemble(hypothesis, out, true);
  out.free_right = right();
  out.solution = solve_scaled(hypothesis, out);
  return out;
}

Fit Bench::fit(const Hypothesis& hypothesis) const {
  Fit out;
  out.columns = assemble(hypothesis, out, true);
  Eigen::VectorXd fixed = Eigen::VectorXd::Zero(out.columns.cols());
  // Nuisances may not go further than what is known of them: at a bound they stay there, and what
  // they would have taken is left for physics to explain.
  for (bool held = true; held;) {
    out.free_columns = out.columns;
    for (Eigen::Index i = 0; i < fixed.size(); ++i)
      if (fixed[i] != 0.0) out.free_columns.col(i).setZero();
    out.free_right = right() - out.columns * fixed;
    out.solution = solve_scaled(hypothesis, out);
    held = false;
    for (Eigen::Index i = out.columns.cols() - prior_count; i < out.columns.cols(); ++i) {
      if (fixed[i] != 0.0 || std::abs(out.solution.coefficients[i]) <= nuisance_bound) continue;
      fixed[i] = std::copysign(nuisance_bound, out.solution.coefficients[i]);
      held = true;
    }
  }
  out.solution.coefficients += fixed;
  const Eigen::Index held_none = out.columns.cols() - prior_count;
  out.columns.leftCols(held_none) = out.free_columns.leftCols(held_none);
  return out;
}

Eigen::VectorXd Bench::raw_residual(const Hypothesis& hypothesis) const {
  Fit ignored;
  Eigen::VectorXd out =
      -(assemble(hypothesis, ignored, false) * fit(hypothesis).solution.coefficients);
  out.head(experiment_.rows()) += experiment_.measured;
  return out;
}

Eigen::VectorXd Bench::right() const {
  Eigen::VectorXd measured = Eigen::VectorXd::Zero(total_rows());
  measured.head(experiment_.rows()) = experiment_.measured;
  return (*whitening_)(measured);
}

}  // namespace searig::estimator
