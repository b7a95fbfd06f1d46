#include "estimator/diagnosis/answer/nameless.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/answer/locate.h"

namespace searig::estimator {
namespace {

/// A region of the load cell's torque, which is guessed from the model, as one of the deflection,
/// which is measured.
std::optional<Region> as_deflection(const Experiment& e, const std::vector<Region>& regions) {
  if (regions.empty() || regions.front().channel != "loadcell_torque_nm") return std::nullopt;
  std::vector<double> inside;
  for (std::size_t i = 0; i < e.motion.theta.size(); ++i)
    if (e.motion.spring_nm[i] >= regions.front().from &&
        e.motion.spring_nm[i] <= regions.front().to)
      inside.push_back(e.motion.theta[i]);
  if (inside.empty()) return std::nullopt;
  const auto [low, high] = std::ranges::minmax_element(inside);
  return Region{"deflection_rad", *low, *high};
}

/// An atom that is local says itself where.
void place(const Atom& atom, const Experiment& e, Located& located) {
  const double start_s = e.start_s;
  if (atom.at_once)
    located.intervals_s = {{start_s + atom.from - 0.5, start_s + atom.from + 0.5}};
  else if (atom.at && atom.channel == "time_s")
    located.intervals_s = {{start_s + atom.from, start_s + atom.to}};
  else if (atom.at)
    located.regions = {{atom.channel, atom.from, atom.to}};
  if (const auto d = as_deflection(e, located.regions)) located.regions.push_back(*d);
  if (atom.channel == "time_s") located.regions.clear();
}

}  // namespace

std::optional<Unexplained> nameless(const Bench& bench, const Hypothesis& final,
                                    const PathResiduals& after, std::size_t atoms_tried,
                                    const Diagnosis& out) {
  Hypothesis without = final;
  std::vector<const Atom*> atoms;
  std::erase_if(without, [&](const Piece& p) {
    if (p.atom) atoms.push_back(p.atom);
    return p.atom != nullptr;
  });
  if (atoms.empty()) return std::nullopt;
  const Atom& first = *atoms.front();
  Unexplained u;
  u.what = first.what;
  u.located = locate(bench, without, final, first.path, first.channel);
  place(first, bench.experiment(), u.located);
  u.located.share = removed(heldout_residuals(bench, without), after, first.path, out).share;
  // Bonferroni over all atoms that were tried, each one degree of freedom.
  const double gain = bench.fit(without).solution.sse - bench.fit(final).solution.sse;
  u.p_value = std::min(1.0, double(atoms_tried) * std::erfc(std::sqrt(std::max(0.0, gain) / 2.0)));
  return u;
}

}  // namespace searig::estimator
