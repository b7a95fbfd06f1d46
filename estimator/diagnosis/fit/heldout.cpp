#include "estimator/diagnosis/fit/heldout.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace searig::estimator {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// The columns of both paths at the load cell's samples: spring + rig, and drive + rig.
struct Predictors {
  Eigen::MatrixXd spring, drive;
  std::vector<bool> compare_spring, compare_drive;
};

Eigen::MatrixXd at_loadcell(const Bench& bench, const Piece& piece, const Seen& seen) {
  const Experiment& e = bench.experiment();
  const Eigen::MatrixXd features = piece.atom ? Eigen::MatrixXd(piece.atom->feature)
                                              : piece.effect->features(e.motion, piece.shape);
  // Any path but `drive` is laid on the load cell's rows, through delay and lag.
  if (e.has_spring())
    return bench.stack(Path::rig, features, seen.delay_s, seen.lag_s).topRows(e.loadcell_rows());
  return e.at_drive.columns(features);
}

std::vector<bool> moving_at_loadcell(const Experiment& e) {
  std::vector<bool> out(std::size_t(e.loadcell_nm.size()), false);
  if (e.motion.w.empty()) return out;
  const Eigen::Map<const Eigen::VectorXd> w(e.motion.w.data(), Eigen::Index(e.motion.w.size()));
  const Eigen::VectorXd speed = e.at_loadcell(w);
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i] = std::abs(speed[Eigen::Index(i)]) > moving_rad_s;
  return out;
}

Predictors predictors(const Bench& bench, const Hypothesis& hypothesis, const Fit& layout) {
  const Experiment& e = bench.experiment();
  const Seen seen = seen_by(hypothesis);
  const Eigen::Index rows = e.loadcell_nm.size(), cols = layout.columns.cols();
  Predictors out{Eigen::MatrixXd::Zero(rows, cols), Eigen::MatrixXd::Zero(rows, cols), {}, {}};
  for (std::size_t i = 0; i < hypothesis.size(); ++i) {
    if (layout.count[i] == 0) continue;
    const Path path = hypothesis[i].atom ? hypothesis[i].atom->path : hypothesis[i].effect->path();
    const Eigen::MatrixXd c = at_loadcell(bench, hypothesis[i], seen);
    if (path != Path::drive) out.spring.middleCols(layout.first[i], layout.count[i]) += c;
    if (path != Path::spring) out.drive.middleCols(layout.first[i], layout.count[i]) += c;
  }
  const Eigen::MatrixXd nuisance = bench.raw_nuisances().topRows(rows);
  out.spring.rightCols(nuisance.cols()) = nuisance;
  out.drive.rightCols(nuisance.cols()) = nuisance;
  const auto covered = e.at_loadcell.covered(0.1);
  const auto moves = moving_at_loadcell(e);
  for (std::size_t i = 0; i < covered.size(); ++i) {
    out.compare_spring.push_back(covered[i] && e.has_spring());
    out.compare_drive.push_back(covered[i] && e.has_drive() && moves[i]);
  }
  return out;
}

PathResiduals blank(Eigen::Index rows) {
  return {Eigen::VectorXd::Constant(rows, nan), Eigen::VectorXd::Constant(rows, nan)};
}

void compare(const Experiment& e, const Predictors& p, const Eigen::VectorXd& x, Eigen::Index row,
             PathResiduals& out) {
  if (p.compare_spring[std::size_t(row)])
    out.spring[row] = e.loadcell_nm[row] - p.spring.row(row).dot(x);
  if (p.compare_drive[std::size_t(row)])
    out.drive[row] = e.loadcell_nm[row] - p.drive.row(row).dot(x);
}

}  // namespace

PathResiduals heldout_residuals(const Bench& bench, const Hypothesis& hypothesis) {
  const Experiment& e = bench.experiment();
  const Fit fit = bench.fit(hypothesis);
  const Predictors p = predictors(bench, hypothesis, fit);
  const Eigen::MatrixXd& columns = fit.free_columns;
  const Eigen::VectorXd& right = fit.free_right;
  Eigen::VectorXd held = fit.solution.coefficients;  // nuisances at their bound stay there
  for (Eigen::Index i = 0; i < held.size(); ++i)
    if (columns.col(i).squaredNorm() > 0 || fit.columns.col(i).squaredNorm() == 0) held[i] = 0.0;
  const std::vector<int> block = bench.blocks();
  const int blocks = *std::max_element(block.begin(), block.end()) + 1;
  const Eigen::MatrixXd all = columns.transpose() * columns;
  const Eigen::VectorXd moment = columns.transpose() * right;
  PathResiduals out = blank(e.loadcell_nm.size());
  for (int b = 0; b < blocks; ++b) {
    Eigen::MatrixXd normal = all;
    Eigen::VectorXd m = moment;
    for (Eigen::Index from = 0; from < columns.rows();) {
      Eigen::Index to = from;
      while (to < columns.rows() && block[std::size_t(to)] == block[std::size_t(from)]) ++to;
      if (block[std::size_t(from)] == b) {
        const auto rows = columns.middleRows(from, to - from);
        normal -= rows.transpose() * rows;
        m -= rows.transpose() * right.segment(from, to - from);
      }
      from = to;
    }
    Eigen::VectorXd scale = all.diagonal().cwiseSqrt();
    scale = (scale.array() > 0).select(scale.cwiseInverse(), 0.0);
    normal = scale.asDiagonal() * normal * scale.asDiagonal();
    normal.diagonal().array() += 1e-6;  // what only the held-out block shows stays near zero
    const Eigen::VectorXd x =
        held + scale.cwiseProduct(Eigen::VectorXd(normal.ldlt().solve(scale.cwiseProduct(m))));
    for (Eigen::Index i = 0; i < e.loadcell_nm.size(); ++i)
      if (std::clamp(int(blocks * e.loadcell_t[std::size_t(i)] / e.motion.t.back()), 0,
                     blocks - 1) == b)
        compare(e, p, x, i, out);
  }
  return out;
}

PathResiduals given_residuals(const Bench& bench, const Hypothesis& hypothesis,
                              const std::vector<Eigen::VectorXd>& amplitudes) {
  const Experiment& e = bench.experiment();
  const Fit layout = bench.fit(hypothesis);
  const Predictors p = predictors(bench, hypothesis, layout);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(layout.columns.cols());
  for (std::size_t i = 0; i < hypothesis.size(); ++i)
    if (layout.count[i] > 0) x.segment(layout.first[i], layout.count[i]) = amplitudes[i];
  PathResiduals out = blank(e.loadcell_nm.size());
  for (Eigen::Index i = 0; i < e.loadcell_nm.size(); ++i) compare(e, p, x, i, out);
  return out;
}

double worse_by(const Bench& bench, const Hypothesis& one, const Hypothesis& other) {
  const auto a = heldout_residuals(bench, one), b = heldout_residuals(bench, other);
  double log_ratio = 0.0;
  if (bench.experiment().has_spring()) log_ratio += std::log(rms_of(a.spring) / rms_of(b.spring));
  if (bench.experiment().has_drive()) log_ratio += std::log(rms_of(a.drive) / rms_of(b.drive));
  return log_ratio;
}

bool misleads(const Bench& bench, const Atom& atom, const Hypothesis& with,
              const Hypothesis& without) {
  constexpr double clearly = 0.2;  // outliers of one block alone may cost a tenth
  return atom.channel != "time_s" && worse_by(bench, with, without) >= clearly;
}

double rms_of(const Eigen::VectorXd& residual) {
  double sum = 0.0;
  Eigen::Index n = 0;
  for (const double r : residual)
    if (std::isfinite(r)) sum += r * r, ++n;
  return n > 0 ? std::sqrt(sum / double(n)) : -1.0;
}

}  // namespace searig::estimator
