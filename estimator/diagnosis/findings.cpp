#include "estimator/diagnosis/findings.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/doubt.h"
#include "estimator/diagnosis/heldout.h"
#include "estimator/diagnosis/locate.h"
#include "estimator/diagnosis/parameters.h"
#include "estimator/diagnosis/remainder.h"
#include "estimator/diagnosis/undecidable.h"

namespace searig::estimator {
namespace {

double share_removed(double before, double after, double floor) {
  return std::clamp(
      (before * before - after * after) / std::max(1e-30, before * before - floor * floor), 0.0,
      1.0);
}

Finding finding(const Bench& bench, const Account& account, const Assessment& a,
                const std::vector<ParameterEstimate>& parameters, const Diagnosis& out) {
  const Piece& piece = account.final.hypothesis[a.piece];
  Finding f;
  f.effect = piece.effect->name();
  f.probability = a.probability;
  f.alternatives = a.alternatives;
  for (const auto& p : parameters)
    if (p.effect == f.effect) f.parameters.push_back(p);
  f.located = locate(bench, a.without, account.final.hypothesis, piece.effect->path(),
                     piece.effect->about().channel);
  const PathResiduals without = heldout_residuals(bench, a.without);
  const PathResiduals with = heldout_residuals(bench, account.final.hypothesis);
  const bool drive = piece.effect->path() == Path::drive || !out.spring;
  f.before_nm = rms_of(drive ? without.drive : without.spring);
  f.after_nm = rms_of(drive ? with.drive : with.spring);
  const PathErrors& whole = drive ? *out.drive : *out.spring;
  f.located.share =
      share_removed(f.before_nm, f.after_nm, std::min(whole.after, whole.noise_floor));
  f.next_experiment = piece.effect->about().separated_by;
  return f;
}

/// An atom that is local says itself where.
void place(const Atom& atom, double start_s, Located& located) {
  if (atom.at_once)
    located.intervals_s = {{start_s + atom.from - 0.5, start_s + atom.from + 0.5}};
  else if (atom.at && atom.channel == "time_s")
    located.intervals_s = {{start_s + atom.from, start_s + atom.to}};
  else if (atom.at)
    located.regions = {{atom.channel, atom.from, atom.to}};
  if (atom.channel == "time_s") located.regions.clear();
}

/// Atoms in the final hypothesis are the mismatch that has no name.
std::optional<Unexplained> nameless(const Bench& bench, const Hypothesis& final,
                                    std::size_t atoms_tried) {
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
  place(first, bench.experiment().start_s, u.located);
  const bool drive = first.path == Path::drive || !bench.experiment().has_spring();
  const auto before = heldout_residuals(bench, without), after = heldout_residuals(bench, final);
  u.located.share = share_removed(rms_of(drive ? before.drive : before.spring),
                                  rms_of(drive ? after.drive : after.spring), 0.0);
  // Bonferroni over all atoms that were tried, each one degree of freedom.
  const double gain = bench.fit(without).solution.sse - bench.fit(final).solution.sse;
  u.p_value = std::min(1.0, double(atoms_tried) * std::erfc(std::sqrt(std::max(0.0, gain) / 2.0)));
  return u;
}

}  // namespace

double state_findings(const Bench& bench, const Account& account, const Model& given,
                      std::size_t atoms, Diagnosis& out) {
  const Hypothesis& final = account.final.hypothesis;
  const Fit fit = bench.fit(final);
  out.extended = model_of(bench, final, fit, fit.solution.coefficients, given);
  const auto parameters = estimate_parameters(bench, final, fit, given);
  for (const auto& a : account.assessments)
    out.findings.push_back(finding(bench, account, a, parameters, out));
  std::ranges::stable_sort(out.findings, std::greater{}, &Finding::probability);
  for (const auto& p : parameters)
    if (given.has(p.effect)) out.numbers.push_back(p);
  out.unexplained = nameless(bench, final, atoms);
  for (const auto look : {wanders, blows, loud_while})
    if (!out.unexplained) out.unexplained = look(bench, final);
  doubt_beside_unexplained(out);
  withdraw_contradicted(account, out);
  const double zero_nm = settle_offsets(bench, final, fit, out);
  merge_late(out);
  leave_to_the_clock(bench, out);
  // The model that is handed on holds what is asserted, not what was taken back.
  std::erase_if(out.extended.terms, [&](const Term& t) {
    const auto says = [&](const Finding& f) {
      return std::ranges::any_of(f.parameters, [&](const auto& p) { return p.effect == t.effect; });
    };
    return !given.has(t.effect) && std::ranges::none_of(out.findings, says);
  });
  for (auto& u : undecidable(bench, final)) out.undecidable.push_back(std::move(u));
  return zero_nm;
}

}  // namespace searig::estimator
