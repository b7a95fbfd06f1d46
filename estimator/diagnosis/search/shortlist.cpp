// Which candidates are worth polishing: the screening half of Search.
#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/search/search.h"
#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

constexpr std::size_t polished_named = 5, tried_unnamed = 6, paired = 8;

bool holds(const Hypothesis& hypothesis, const Effect* effect) {
  return std::ranges::any_of(hypothesis, [&](const Piece& p) { return p.effect == effect; });
}

}  // namespace

Piece Search::extended(const Hypothesis& from, const Effect& effect,
                       std::vector<double> shape) const {
  for (const auto& piece : from)
    if (piece.effect == &effect)
      shape.insert(shape.begin(), piece.shape.begin(), piece.shape.end());
  return {&effect, std::move(shape), nullptr};
}

Hypothesis Search::with(Hypothesis from, const std::vector<Piece>& pieces) const {
  for (const auto& piece : pieces) {
    if (piece.effect) std::erase_if(from, [&](const Piece& p) { return p.effect == piece.effect; });
    from.push_back(piece);
  }
  return from;
}

std::vector<Search::Ranked> Search::screen(const Hypothesis& from, const Projection& projection) {
  std::vector<Ranked> out;
  for (const Effect* effect : catalogue()) {
    if (!effect->applies(bench_.experiment().motion)) continue;
    const auto grid = effect->shape_grid(bench_.experiment().motion);
    // Only sums of branches can take in one more of their kind.
    if (holds(from, effect) && (grid.size() < 2 || !effect->has_branches())) continue;
    Ranked best{{effect, {}, nullptr}, -1.0}, any = best;
    for (const auto& shape : grid) {
      const Piece piece{effect, shape, nullptr};
      const auto gain = projection.gain(bench_.screening_columns(piece));
      if (gain.independence < 1e-3) continue;
      if (gain.sse > any.gain) any = {piece, gain.sse};
      const bool positive = effect->path() == Path::observation || !effect->tied_to().empty();
      if (positive ? gain.coefficients[0] <= 0 : !effect->physical(gain.coefficients)) continue;
      if (gain.sse > best.gain) best = {piece, gain.sse};
    }
    // Unphysical alone, it may still be one of a pair.
    if (best.gain < 0 && any.gain >= 0) best = {any.piece, 0.0};
    if (best.gain >= 0) out.push_back(best);
  }
  std::ranges::sort(out, std::greater{}, &Ranked::gain);
  return out;
}

std::vector<std::vector<Piece>> Search::shortlist_named(const Hypothesis& from) {
  const Fit fit = bench_.fit(from);
  const Projection projection(fit.free_columns, fit.free_right);
  const auto ranked = screen(from, projection);
  std::vector<std::vector<Piece>> out;
  for (const auto& r : ranked)
    if (out.size() < polished_named && r.gain > std::max(8.0, 0.05 * ranked.front().gain))
      out.push_back({extended(from, *r.piece.effect, r.piece.shape)});
  std::vector<std::vector<Piece>> late;
  for (const auto& pieces : out)
    for (auto& pair : with_late_loadcell(from, pieces)) late.push_back(std::move(pair));
  out.insert(out.end(), late.begin(), late.end());
  if (const auto pair = best_pair(from, projection, ranked); !pair.empty()) out.push_back(pair);
  return out;
}

/// A damper hides behind a load cell that is late by c/k, and the other way round. Where a term
/// only fits if the load cell's clock is wrong by more than it can be, the late load cell is its
/// partner.
std::vector<std::vector<Piece>> Search::with_late_loadcell(const Hypothesis& from,
                                                           const std::vector<Piece>& pieces) {
  const Effect *delay = find_effect("rig.delay"), *lag = find_effect("rig.lag");
  const bool spring = pieces.front().effect->path() == Path::spring;
  if (!spring || holds(from, delay) || holds(from, lag)) return {};
  const Fit fit = bench_.unbounded_fit(with(from, pieces));
  const double late_s =
      -fit.solution.coefficients.tail(Bench::prior_count)[0] * bench_.experiment().clock_sd_s;
  if (std::abs(late_s) < 2.0 * bench_.experiment().clock_sd_s) return {};
  std::vector<std::vector<Piece>> out{{pieces.front(), {delay, {late_s}, nullptr}}};
  if (late_s > 0) out.push_back({pieces.front(), {lag, {late_s}, nullptr}});
  return out;
}

std::vector<Piece> Search::best_pair(const Hypothesis& from, const Projection& projection,
                                     const std::vector<Ranked>& ranked) {
  if (ranked.empty()) return {};
  double best = std::max(1.3 * ranked.front().gain, ranked.front().gain + 60.0);
  std::vector<Piece> out;
  const std::size_t n = std::min(paired, ranked.size());
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 1; j < n; ++j) {
      const Piece &a = ranked[i].piece, &b = ranked[j].piece;
      if (holds(from, a.effect) || holds(from, b.effect)) continue;
      const Eigen::MatrixXd ca = bench_.screening_columns(a), cb = bench_.screening_columns(b);
      Eigen::MatrixXd both(ca.rows(), ca.cols() + cb.cols());
      both << ca, cb;
      const auto gain = projection.gain(both);
      const auto fine = [](const Piece& p, const Eigen::VectorXd& x) {
        const bool positive = p.effect->path() == Path::observation || !p.effect->tied_to().empty();
        return positive ? x[0] > 0 : p.effect->physical(x);
      };
      if (gain.sse <= best || !fine(a, gain.coefficients.head(ca.cols())) ||
          !fine(b, gain.coefficients.tail(cb.cols())))
        continue;
      best = gain.sse;
      out = {a, b};
    }
  return out;
}

std::vector<std::vector<Piece>> Search::shortlist_unnamed(const Hypothesis& from) {
  const Fit fit = bench_.fit(from);
  const Projection projection(fit.free_columns, fit.free_right);
  std::vector<std::pair<double, const Atom*>> ranked;
  for (const auto& atom : atoms_) {
    const auto gain = projection.gain(bench_.screening_columns({nullptr, {}, &atom}));
    if (gain.independence > 1e-2) ranked.emplace_back(gain.sse, &atom);
  }
  std::ranges::sort(ranked, std::greater{});
  std::vector<std::vector<Piece>> out;
  for (std::size_t i = 0; i < std::min(tried_unnamed, ranked.size()); ++i)
    out.push_back({Piece{nullptr, {}, ranked[i].second}});
  return out;
}

}  // namespace searig::estimator
