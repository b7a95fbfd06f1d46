#include "estimator/diagnosis/search.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/left.h"
#include "estimator/diagnosis/parameters.h"
#include "estimator/diagnosis/polish.h"
#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

constexpr double price_per_value = 6.0;  // of an amplitude or a shape value, in deviance
constexpr double price_of_no_name = 10.0;
constexpr std::size_t most_unnamed = 2;  // polished, of those that explain something

double price(const Bench& bench, const Hypothesis& hypothesis) {
  double sum = 0.0;
  for (const auto& piece : hypothesis) {
    if (piece.atom) {
      sum += price_per_value + price_of_no_name;
      continue;
    }
    sum += price_per_value * double(piece.effect->free_shape(piece.shape));
    if (piece.effect->tied_to().empty())
      sum += price_per_value * double(bench.raw_columns(piece, 0.0, 0.0).cols());
  }
  return sum;
}

/// Beyond four standard deviations a residual counts only linearly (P. Huber, 1964).
double huber(double e) {
  return std::abs(e) < 4.0 ? e * e : 8.0 * std::abs(e) - 16.0;
}

}  // namespace

Search::Search(Bench& bench, const std::vector<Atom>& dense, const std::vector<Atom>& atoms,
               const Model& model, Criteria criteria)
    : bench_(bench), atoms_(atoms), model_(model), criteria_(criteria) {
  for (const auto& term : model.terms) given_.insert(find_effect(term.effect));
  for (const auto& atom :
       dense)  // slow noise is noise: it must not be cleaned out with the time cells
    if (atom.channel != "time_s") cleaners_.push_back({nullptr, {}, &atom});
  for (const Effect* effect : catalogue()) {
    if (!effect->applies(bench.experiment().motion)) continue;
    if (effect->name() == "drive.motor") continue;  // its gain is held (Bench::learn_noise)
    const auto grid = effect->shape_grid(bench.experiment().motion);
    if (grid.size() > 20) continue;  // a wave at every frequency would take the noise along
    for (const auto& shape : grid) cleaners_.push_back({effect, shape, nullptr});
  }
}

void Search::learn_noise(const Hypothesis& hypothesis) {
  bench_.learn_noise(hypothesis, cleaners_);
}

Scored Search::score(Hypothesis hypothesis) {
  hypothesis = polish(bench_, hypothesis);
  const Fit fit = bench_.fit(hypothesis);
  return {hypothesis, deviance(fit), price(bench_, hypothesis)};
}

double Search::deviance(const Fit& fit) const {
  double out = fit.solution.coefficients.tail(Bench::prior_count).squaredNorm();
  for (const double e : fit.solution.residual.head(bench_.experiment().rows())) out += huber(e);
  return out;
}

Step Search::step(const Hypothesis& from) {
  Step out;
  out.before = score(from);
  const auto hold = [&](const std::vector<std::vector<Piece>>& all, std::vector<Contender>& into) {
    for (const auto& pieces : all) {
      // From the shapes as they are: without what is missing they may run away.
      Contender c{pieces, score(with(from, pieces)), 0.0};
      c.gain = out.before.cost() - c.scored.cost();
      const bool atom = pieces.front().atom;
      if (atom ? explains(c, out.before) : believable(c)) into.push_back(std::move(c));
      if (atom && into.size() == most_unnamed) break;
    }
    std::ranges::sort(into, std::greater{}, &Contender::gain);
  };
  hold(shortlist_named(from), out.named);
  hold(shortlist_unnamed(from), out.unnamed);
  return out;
}

/// The drive's residual counts in amperes. A function of the current can take back the current's
/// errors while the torque constant grows, which gains, yet leaves more newton metres than before.
bool Search::explains(const Contender& c, const Scored& from) const {
  const auto power = [&](const Scored& s) {
    return left_of(bench_, bench_.raw_residual(s.hypothesis), true).power();
  };
  return c.pieces.front().atom->path != Path::drive || power(c.scored) < power(from);
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
  const double share =
      c.pieces.front().atom ? criteria_.least_unnamed_of_largest : criteria_.least_of_largest;
  return passes(c, from) && strength(bench_, from, c.scored) >= share * largest_;
}

Scored Search::add_named(Scored from, std::vector<Step>& trail) {
  for (int terms = 0; terms <= criteria_.most_terms; ++terms) {
    learn_noise(from.hypothesis);
    trail.push_back(step(from.hypothesis));
    const Step& seen = trail.back();
    from = seen.before;
    if (terms == criteria_.most_terms || seen.named.empty()) break;
    const Contender& best = seen.named.front();
    if (!stands_out(best, from)) break;
    largest_ = std::max(largest_, strength(bench_, from, best.scored));
    from = best.scored;
    bench_.learn_torque(from.hypothesis);
  }
  return from;
}

Scored Search::add_unnamed(Scored from, int most) {
  for (int i = 0; i < most; ++i) {
    learn_noise(from.hypothesis);
    const Step seen = step(from.hypothesis);
    if (seen.unnamed.empty() || !stands_out(seen.unnamed.front(), seen.before)) break;
    from = seen.unnamed.front().scored;
  }
  return from;
}

Scored Search::add_either(Scored from, int most) {
  for (int i = 0; i < most; ++i) {
    learn_noise(from.hypothesis);
    const Step seen = step(from.hypothesis);
    const Contender* best = nullptr;
    if (!seen.named.empty()) best = &seen.named.front();
    if (!seen.unnamed.empty() &&
        (!best || seen.unnamed.front().gain > 1.04 * best->gain + price_of_no_name))
      best = &seen.unnamed.front();
    if (!best || !stands_out(*best, seen.before)) break;
    from = best->scored;
  }
  return from;
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
