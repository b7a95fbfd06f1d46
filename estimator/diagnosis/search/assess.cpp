#include "estimator/diagnosis/search/assess.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

/// Rivals fit other functional forms of the same physics, so likelihoods are tempered: one part in
/// fifty of the gain counts as one unit of log likelihood.
double temperature(double gain) {
  return 1.0 + 0.02 * std::max(0.0, gain);
}

/// Of a rival that brings less than the `most` that was found.
double likelihood(double gain, double most) {
  return std::exp(std::min(0.0, -(most - gain) / (2.0 * temperature(most))));
}

constexpr double worth_a_word = 0.01;  // in likelihood

/// How likely rivals for the place of a piece are, the piece itself being 1. They have to fit as
/// well and to predict as well: the best of hundreds of features fits well by being chosen. Of a
/// while that others do not see nothing is predicted.
class Rivalry {
 public:
  Rivalry(const Search& search, const Scored& final, const Step& without)
      : search_(search),
        before_(search.heldout(without.before.hypothesis)),
        predicted_(before_ - search.heldout(final.hypothesis)),
        gain_(without.before.cost() - final.cost()) {}

  double of(const Contender& c) const {
    const double fits = likelihood(c.gain, gain_);
    const Atom* atom = c.pieces.front().atom;
    if (atom && atom->channel == "time_s" && !atom->at_once) return fits;
    return std::min(fits, likelihood(before_ - search_.heldout(c.scored.hypothesis), predicted_));
  }

 private:
  const Search& search_;
  double before_, predicted_, gain_;
};

/// Whether the spring's residual and the drive's want the same amplitude of a spring term.
bool both_agree(const Bench& bench, const Hypothesis& final, std::size_t piece, double gain) {
  const Experiment& e = bench.experiment();
  const Piece& p = final[piece];
  const Path path = p.atom ? p.atom->path : p.effect->path();
  if (path != Path::spring || !e.has_drive() || (p.effect && !p.effect->tied_to().empty()))
    return true;
  const Fit fit = bench.fit(final);
  const Seen seen = seen_by(final);
  Eigen::MatrixXd loadcell_only = bench.columns(p, seen.delay_s, seen.lag_s);
  loadcell_only.bottomRows(loadcell_only.rows() - e.loadcell_rows()).setZero();
  const double split = Projection(fit.free_columns, fit.free_right).gain(loadcell_only).sse;
  return split < std::max(40.0, 0.25 * gain);
}

}  // namespace

double existence(double gain, double rho) {
  const double from_gain = 1.0 / (1.0 + std::exp(-(gain - 26.0) / 8.0));
  const double from_size = 1.0 / (1.0 + std::exp(-(rho - 0.10) / 0.025));
  return from_gain * from_size;
}

double beyond_form(double share) {
  return 1.0 / (1.0 + std::exp(-(share - 0.045) / 0.01));
}

Assessment assess(Search& search, Bench& bench, const Scored& final, std::size_t piece) {
  Assessment out;
  out.piece = piece;
  const Piece& own = final.hypothesis[piece];
  const Step step = search.step(all_but(final.hypothesis, piece));
  out.without = step.before.hypothesis;
  out.gain = step.before.cost() - final.cost();
  out.rho = strength(bench, step.before, final);
  if (!step.named.empty() && step.named.front().scored.cost() < final.cost() - 15.0)
    out.better = step.named.front().scored;
  out.consistent = both_agree(bench, final.hypothesis, piece, out.gain);

  const Rivalry rivalry(search, final, step);
  std::map<std::string, double> weight;
  double total = 1.0;
  const auto family = [](const std::string& name) {  // when the load cell answers, not what
    return name == "rig.lag" ? std::string("rig.delay") : name;
  };
  for (const auto& c : step.named) {
    const std::string& name = c.pieces.front().effect->name();
    if (c.pieces.size() > 1 || family(name) == family(own.effect->name())) continue;
    const double w = rivalry.of(c);
    if (w <= worth_a_word) continue;
    weight[name] = w, total += w;
    out.rivals.push_back(c.scored.hypothesis);
  }
  double nameless = 0.0;
  for (const auto& c : step.unnamed) nameless = std::max(nameless, rivalry.of(c));
  total += nameless;
  out.probability = existence(out.gain, out.rho) / total;
  for (const auto& [name, w] : weight)
    out.alternatives.push_back({name, w / total, own.effect->about().separated_by});
  if (nameless > worth_a_word)
    out.alternatives.push_back(
        {"", nameless / total, "a recording of the same motion at another place, time or load"});
  std::ranges::sort(out.alternatives, std::greater{}, &Alternative::probability);
  return out;
}

std::set<std::string> names_near(Search& search, const Scored& final, std::size_t atom) {
  const Step step = search.step(all_but(final.hypothesis, atom));
  const Rivalry rivalry(search, final, step);
  std::set<std::string> out;
  for (const auto& c : step.named)
    if (c.pieces.size() == 1 && rivalry.of(c) > worth_a_word)
      out.insert(c.pieces.front().effect->name());
  return out;
}

}  // namespace searig::estimator
