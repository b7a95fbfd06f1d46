#include "estimator/diagnosis/search/search.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/fit/polish.h"
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
  const double left_before = atoms_.empty() ? 0.0 : left_of_drive(out.before);
  const auto hold = [&](const std::vector<std::vector<Piece>>& all, std::vector<Contender>& into) {
    for (const auto& pieces : all) {
      // From the shapes as they are: without what is missing they may run away.
      Contender c{pieces, score(with(from, pieces)), 0.0};
      c.gain = out.before.cost() - c.scored.cost();
      const bool atom = pieces.front().atom;
      if (atom ? explains(c, left_before) : believable(c)) into.push_back(std::move(c));
      if (atom && into.size() == most_unnamed) break;
    }
    std::ranges::sort(into, std::greater{}, &Contender::gain);
  };
  hold(shortlist_named(from), out.named);
  hold(shortlist_unnamed(from), out.unnamed);
  return out;
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
    const double largest = strength(bench_, from, best.scored);
    largest_ = std::max(largest_, largest);
    if (best.pieces.front().effect->path() == Path::drive)
      largest_of_drive_ = std::max(largest_of_drive_, largest);
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

}  // namespace searig::estimator
