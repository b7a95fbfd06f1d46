// Search: what a contender must show before it counts.
#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/fit/left.h"
#include "estimator/diagnosis/fit/parameters.h"
#include "estimator/diagnosis/search/search.h"

namespace searig::estimator {

double Search::left_of_drive(const Scored& scored) const {
  return left_of(bench_, bench_.raw_residual(scored.hypothesis), true).power();
}

/// The drive's residual counts in amperes. A function of the current can take back the current's
/// errors while the torque constant grows, which gains, yet leaves more newton metres than before.
bool Search::explains(const Contender& c, double left_before) const {
  return c.pieces.front().atom->path != Path::drive || left_of_drive(c.scored) < left_before;
}

bool Search::at_its_bound(const Piece& piece) const {
  for (std::size_t v = 0; v < piece.effect->free_shape(piece.shape); ++v) {
    const auto range = piece.effect->shape_range(bench_.experiment().motion, piece.shape, v);
    if (piece.shape[v] < 1.02 * range.lower && range.lower > 0) return true;
    if (piece.shape[v] > 0.98 * range.upper) return true;
  }
  return false;
}

bool Search::believable(const Contender& contender) {
  const auto& hypothesis = contender.scored.hypothesis;
  const Fit fit = bench_.fit(hypothesis);
  const Model numbers = model_of(bench_, hypothesis, fit, fit.solution.coefficients, model_);
  for (const auto& piece : hypothesis) {
    if (!piece.effect || given_.contains(piece.effect)) continue;
    if (at_its_bound(piece)) return false;
    for (const auto& p : piece.effect->parameters()) {  // a softening by more than everything
      const auto value = numbers.get(piece.effect->name(), p.name);
      if (value && (*value < p.lower || *value > p.upper)) return false;
    }
  }
  for (std::size_t i = 0; i < hypothesis.size(); ++i) {
    const auto mine = [&](const Piece& p) { return p.effect == hypothesis[i].effect; };
    if (fit.count[i] == 0 || std::ranges::none_of(contender.pieces, mine)) continue;
    if (!hypothesis[i].effect->tied_to().empty()) continue;
    const Eigen::VectorXd amplitude = fit.amplitudes(i);
    if (!hypothesis[i].effect->physical(amplitude)) return false;
    const double feigned =
        hypothesis[i].effect->feigned(model_, bench_.experiment().loadcell_width_s);
    if (feigned > 0) {
      const double beyond = (amplitude.norm() - feigned) / amplitude.norm();
      const double least = 0.05 * double(bench_.experiment().loadcell_rows());
      if (beyond <= 0 || contender.gain * beyond * beyond < std::max(criteria_.least_gain, least))
        return false;
    }
  }
  return true;
}

bool Search::passes(const Contender& c, const Scored& from) {
  const bool atom = c.pieces.front().atom;
  if (c.gain < (atom ? criteria_.least_unnamed_gain : criteria_.least_gain)) return false;
  if (strength(bench_, from, c.scored) < (atom ? criteria_.least_unnamed_rho : criteria_.least_rho))
    return false;
  return atom || predicts(c, from);  // an atom may live in one block, where no other predicts it
}

bool Search::predicts(const Contender& c, const Scored& from) const {
  return heldout(c.scored.hypothesis) < heldout(from.hypothesis);
}

double Search::heldout(const Hypothesis& hypothesis) const {
  const Fit fit = bench_.fit(hypothesis);
  return heldout_sse(fit.free_columns, fit.free_right, bench_.blocks());
}

bool Search::stands_out(const Contender& c, const Scored& from) {
  const Atom* atom = c.pieces.front().atom;
  const double share = atom ? criteria_.least_unnamed_of_largest : criteria_.least_of_largest;
  // What the form of a spring's effect leaves over shows at the load cell, not in the drive alone.
  const double largest = atom && atom->path == Path::drive ? largest_of_drive_ : largest_;
  return passes(c, from) && strength(bench_, from, c.scored) >= share * largest;
}

double strength(Bench& bench, const Scored& without, const Scored& with) {
  const Experiment& e = bench.experiment();
  const Eigen::VectorXd a = bench.raw_residual(without.hypothesis);
  const Eigen::VectorXd b = bench.raw_residual(with.hypothesis);
  double largest = 0.0;
  const auto in_block = [&](Eigen::Index from, Eigen::Index to) {
    double change = 0.0, left = 0.0;
    for (Eigen::Index i = from; i < to; ++i) {
      if (!e.usable[std::size_t(i)]) continue;
      const double w = e.weight[std::size_t(i)];
      change += w * w * (a[i] - b[i]) * (a[i] - b[i]);
      left += w * w * b[i] * b[i];
    }
    if (left > 0) largest = std::max(largest, std::sqrt(change / left));
  };
  in_block(0, e.loadcell_rows());
  in_block(e.loadcell_rows(), e.rows());
  return largest;
}

}  // namespace searig::estimator
