#include "estimator/diagnosis/search.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/polish.h"
#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

constexpr double price_per_value = 6.0;  // of an amplitude or a shape value, in deviance
constexpr double price_of_no_name = 10.0;
constexpr std::size_t polished_named = 5, polished_unnamed = 2;

bool holds(const Hypothesis& hypothesis, const Effect* effect) {
  return std::ranges::any_of(hypothesis, [&](const Piece& p) { return p.effect == effect; });
}

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

/// Motor gain of a fit, N*m per A; 1 where the drive rows do not share it with the spring.
double motor_gain(const Bench& bench, const Hypothesis& hypothesis, const Fit& fit) {
  if (!bench.experiment().has_spring()) return 1.0;
  for (std::size_t i = 0; i < hypothesis.size(); ++i)
    if (hypothesis[i].effect && hypothesis[i].effect->name() == "drive.motor")
      return std::max(1e-9, std::abs(fit.amplitudes(i)[0]));
  return 1.0;
}

/// Mean of squares beyond four standard deviations grows only linearly (P. Huber, 1964).
double huber_mean(const Eigen::VectorXd& x) {
  double sum = 0.0;
  for (const double e : x) sum += std::abs(e) < 4.0 ? e * e : 8.0 * std::abs(e) - 16.0;
  return sum / double(std::max<Eigen::Index>(1, x.size()));
}

}  // namespace

Search::Search(Bench& bench, const std::vector<Atom>& dense, const std::vector<Atom>& atoms,
               const Model& model, Criteria criteria)
    : bench_(bench), dense_(dense), atoms_(atoms), model_(model), criteria_(criteria) {}

Scored Search::score(Hypothesis hypothesis) {
  const Whitening before = bench_.whitening();
  const auto own_noise = [&](const Fit& fit) {
    const Eigen::VectorXd residual = bench_.raw_residual(hypothesis, fit);
    return Whitening(bench_.experiment(), residual.head(bench_.experiment().rows()));
  };
  for (int round = 0; round < 5; ++round) {  // shapes, amplitudes and noise settle together
    if (round == 0 || round == 3) hypothesis = polish(bench_, hypothesis, round == 0 ? 12 : 6);
    bench_.set_noise(own_noise(bench_.fit(hypothesis)));
  }
  const Fit fit = bench_.fit(hypothesis);
  Scored out{hypothesis, deviance(hypothesis, fit), price(bench_, hypothesis)};
  bench_.set_noise(before);
  return out;
}

double Search::deviance(const Hypothesis& hypothesis, const Fit& fit) const {
  const Whitening& w = bench_.whitening();
  const Eigen::Index rows = bench_.experiment().rows();
  Eigen::VectorXd block[2] = {Eigen::VectorXd(rows), Eigen::VectorXd(rows)};
  Eigen::Index n[2] = {0, 0};
  for (Eigen::Index i = 0; i < rows; ++i)
    if (w.counts()[std::size_t(i)]) {
      const int b = i < w.split() ? 0 : 1;
      block[b][n[b]++] = fit.solution.residual[i];
    }
  const double sd[2] = {w.loadcell().sd, w.drive().sd / motor_gain(bench_, hypothesis, fit)};
  double out = fit.solution.residual.tail(fit.solution.residual.size() - rows).squaredNorm();
  for (int b = 0; b < 2; ++b)
    if (n[b] > 0)
      out += double(n[b]) * std::log(sd[b] * sd[b] * huber_mean(block[b].head(n[b])));
  return out;
}

Piece Search::extended(const Hypothesis& from, const Effect& effect,
                       std::vector<double> shape) const {
  for (const auto& piece : from)
    if (piece.effect == &effect) shape.insert(shape.begin(), piece.shape.begin(), piece.shape.end());
  return {&effect, std::move(shape), nullptr};
}

Hypothesis Search::with(Hypothesis from, const Piece& piece) const {
  if (piece.effect) std::erase_if(from, [&](const Piece& p) { return p.effect == piece.effect; });
  from.push_back(piece);
  return from;
}

std::vector<Piece> Search::shortlist_named(const Hypothesis& from) {
  const Fit fit = bench_.fit(from);
  const Projection projection(fit.columns, bench_.right());
  struct Ranked {
    Piece piece;
    double gain;
  };
  std::vector<Ranked> ranked;
  for (const Effect* effect : catalogue()) {
    if (!effect->applies(bench_.experiment().motion)) continue;
    const bool extends = holds(from, effect);
    const auto grid = effect->shape_grid(bench_.experiment().motion);
    // Only sums of branches can take in one more of their kind.
    if (extends && (grid.size() < 2 || !effect->has_branches())) continue;
    Ranked best{{effect, {}, nullptr}, 0.0};
    for (const auto& shape : grid) {
      const Piece piece{effect, shape, nullptr};
      const auto gain = projection.gain(bench_.screening_columns(piece));
      const bool positive = effect->path() == Path::observation || !effect->tied_to().empty();
      if (gain.sse <= best.gain || gain.independence < 1e-3) continue;
      if (positive ? gain.coefficients[0] <= 0 : !effect->physical(gain.coefficients)) continue;
      best = {piece, gain.sse};
    }
    if (best.gain < 8.0) continue;
    best.piece = extended(from, *effect, best.piece.shape);
    ranked.push_back(best);
  }
  std::ranges::sort(ranked, std::greater{}, &Ranked::gain);
  std::vector<Piece> out;
  for (const auto& r : ranked)
    if (out.size() < polished_named && r.gain > 0.05 * ranked.front().gain) out.push_back(r.piece);
  return out;
}

std::vector<Piece> Search::shortlist_unnamed(const Hypothesis& from, std::size_t most) {
  const Fit fit = bench_.fit(from);
  const Projection projection(fit.columns, bench_.right());
  std::vector<std::pair<double, const Atom*>> ranked;
  for (const auto& atom : atoms_) {
    const auto gain = projection.gain(bench_.screening_columns({nullptr, {}, &atom}));
    if (gain.independence > 1e-2) ranked.emplace_back(gain.sse, &atom);
  }
  std::ranges::sort(ranked, std::greater{});
  std::vector<Piece> out;
  for (std::size_t i = 0; i < std::min(most, ranked.size()); ++i)
    out.push_back({nullptr, {}, ranked[i].second});
  return out;
}

Step Search::step(const Scored& from) {
  bench_.learn_noise(from.hypothesis, dense_);
  Step out;
  out.before = from;
  // The noise as seen from here may lead to a better optimum than the one found on the way.
  if (auto again = score(from.hypothesis); again.deviance < from.deviance) out.before = again;
  const auto hold = [&](const std::vector<Piece>& pieces, std::vector<Contender>& into) {
    for (const auto& piece : pieces) {
      Contender c{piece, score(with(from.hypothesis, piece)), 0.0};
      c.gain = out.before.cost() - c.scored.cost();
      if (piece.atom || believable(c)) into.push_back(std::move(c));
    }
    std::ranges::sort(into, std::greater{}, &Contender::gain);
  };
  hold(shortlist_named(from.hypothesis), out.named);
  hold(shortlist_unnamed(from.hypothesis, polished_unnamed), out.unnamed);
  return out;
}

bool Search::believable(const Contender& contender) {
  const auto& hypothesis = contender.scored.hypothesis;
  const Fit fit = bench_.fit(hypothesis);
  for (std::size_t i = 0; i < hypothesis.size(); ++i) {
    if (hypothesis[i].effect != contender.piece.effect || fit.count[i] == 0) continue;
    if (!hypothesis[i].effect->tied_to().empty()) continue;
    const Eigen::VectorXd amplitude = fit.amplitudes(i);
    if (!hypothesis[i].effect->physical(amplitude)) return false;
    const double feigned =
        hypothesis[i].effect->feigned(model_, bench_.experiment().loadcell_width_s);
    if (feigned > 0) {
      const double beyond = (amplitude.norm() - feigned) / amplitude.norm();
      if (beyond <= 0 || contender.gain * beyond * beyond < criteria_.least_gain) return false;
    }
  }
  return true;
}

bool Search::passes(const Contender& c, const Scored& from) {
  if (c.gain < (c.piece.atom ? criteria_.least_unnamed_gain : criteria_.least_gain)) return false;
  if (strength(bench_, from, c.scored) < criteria_.least_rho) return false;
  const auto blocks = bench_.blocks();
  const double with = heldout_sse(bench_.fit(c.scored.hypothesis).columns, bench_.right(), blocks);
  const double without = heldout_sse(bench_.fit(from.hypothesis).columns, bench_.right(), blocks);
  return without - with > 0.0;
}

bool Search::stands_out(const Contender& c, const Scored& from) {
  return passes(c, from) &&
         strength(bench_, from, c.scored) >= criteria_.least_of_largest * largest_;
}

Scored Search::add_named(Scored from, std::vector<Step>& trail) {
  for (int terms = 0; terms <= criteria_.most_terms; ++terms) {
    trail.push_back(step(from));
    const Step& seen = trail.back();
    if (terms == criteria_.most_terms || seen.named.empty()) break;
    if (!stands_out(seen.named.front(), from)) break;
    largest_ = std::max(largest_, strength(bench_, from, seen.named.front().scored));
    from = seen.named.front().scored;
    bench_.learn_torque(from.hypothesis);
  }
  return from;
}

Scored Search::add_unnamed(Scored from, int most) {
  for (int i = 0; i < most; ++i) {
    const Step seen = step(from);
    if (seen.unnamed.empty() || !stands_out(seen.unnamed.front(), from)) break;
    from = seen.unnamed.front().scored;
  }
  return from;
}

Scored Search::add_either(Scored from, int most) {
  for (int i = 0; i < most; ++i) {
    const Step seen = step(from);
    const Contender* best = nullptr;
    if (!seen.named.empty()) best = &seen.named.front();
    if (!seen.unnamed.empty() &&
        (!best || seen.unnamed.front().gain > 1.04 * best->gain + price_of_no_name))
      best = &seen.unnamed.front();
    if (!best || !stands_out(*best, from)) break;
    from = best->scored;
  }
  return from;
}

double strength(Bench& bench, const Scored& without, const Scored& with) {
  const Experiment& e = bench.experiment();
  const Eigen::VectorXd a = bench.raw_residual(without.hypothesis, bench.fit(without.hypothesis));
  const Eigen::VectorXd b = bench.raw_residual(with.hypothesis, bench.fit(with.hypothesis));
  double largest = 0.0;
  const auto in_block = [&](Eigen::Index from, Eigen::Index to) {
    double change = 0.0, left = 0.0;
    for (Eigen::Index i = from; i < to; ++i)
      if (e.usable[std::size_t(i)]) change += (a[i] - b[i]) * (a[i] - b[i]), left += b[i] * b[i];
    if (left > 0) largest = std::max(largest, std::sqrt(change / left));
  };
  in_block(0, e.loadcell_rows());
  in_block(e.loadcell_rows(), e.rows());
  return largest;
}

}  // namespace searig::estimator
