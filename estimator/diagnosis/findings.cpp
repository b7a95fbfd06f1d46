#include "estimator/diagnosis/findings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "estimator/diagnosis/doubt.h"
#include "estimator/diagnosis/heldout.h"
#include "estimator/diagnosis/locate.h"
#include "estimator/diagnosis/next_experiment.h"
#include "estimator/diagnosis/parameters.h"
#include "estimator/diagnosis/polish.h"
#include "estimator/diagnosis/remainder.h"
#include "estimator/diagnosis/undecidable.h"
#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

double share_removed(double before, double after, double floor) {
  return std::clamp(
      (before * before - after * after) / std::max(1e-30, before * before - floor * floor), 0.0,
      1.0);
}

/// Held-out rms of one path without and with a piece, and the share of the mismatch it removes.
struct Removed {
  double before_nm = 0.0, after_nm = 0.0, share = 0.0;
};

Removed removed_from(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                     const std::optional<PathErrors>& path) {
  if (!path) return {};
  const double b = rms_of(before), a = rms_of(after);
  return {b, a, share_removed(b, a, std::min(path->after, path->noise_floor))};
}

/// In the path that the piece enters; what the rig does enters both, and counts where it does more.
Removed removed(const PathResiduals& before, const PathResiduals& after, Path path,
                const Diagnosis& out) {
  const Removed spring = removed_from(before.spring, after.spring, out.spring);
  const Removed drive = removed_from(before.drive, after.drive, out.drive);
  if (path == Path::drive || !out.spring) return drive;
  if (path == Path::spring || !out.drive) return spring;
  return drive.share > spring.share ? drive : spring;
}

/// Nature's form of an effect is not the catalogue's, so that the number of the one is known of the
/// other to a share of itself at best, however quiet the recording is.
ParameterEstimate with_doubt_of_form(ParameterEstimate p) {
  constexpr double share = 0.02;
  const double half = std::hypot(0.5 * (p.upper - p.lower), share * p.value);
  if (p.upper > p.lower) p.lower = p.value - half, p.upper = p.value + half;
  return p;
}

Finding finding(const Bench& bench, const Account& account, const PathResiduals& after,
                const Assessment& a, const std::vector<ParameterEstimate>& parameters,
                const Diagnosis& out) {
  const Piece& piece = account.final.hypothesis[a.piece];
  Finding f;
  f.effect = piece.effect->name();
  f.probability = a.probability;
  f.alternatives = a.alternatives;
  for (const auto& p : parameters)
    if (p.effect == f.effect) f.parameters.push_back(with_doubt_of_form(p));
  f.located = locate(bench, a.without, account.final.hypothesis, piece.effect->path(),
                     piece.effect->about().channel);
  const Removed gone =
      removed(heldout_residuals(bench, a.without), after, piece.effect->path(), out);
  f.before_nm = gone.before_nm, f.after_nm = gone.after_nm;
  f.located.share = gone.share;
  f.next_experiment = piece.effect->about().separated_by;
  return f;
}

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

/// Atoms in the final hypothesis are the mismatch that has no name.
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

}  // namespace

namespace {

constexpr double telling = 30.0;  // in deviance: less does not settle it

/// What an experiment is expected to bring.
std::string expectation(double deviance, bool open) {
  char text[96];
  std::snprintf(text, sizeof text, "%s by %.0f standard deviations",
                open ? "there its rivals would fall behind" : "there it would stand out",
                std::sqrt(deviance));
  return text;
}

/// The next experiment of each finding: the motion on which its rivals would fall behind most.
void propose(const Bench& bench, const Account& account, Diagnosis& out) {
  if (out.findings.empty()) return;
  const Rehearsal rehearsal(bench, account.final.hypothesis, out.extended);
  for (std::size_t i = 0; i < out.findings.size(); ++i) {
    Finding& f = out.findings[i];
    const Assessment& a = account.assessments[i];
    const bool open = !a.rivals.empty();
    const auto choice =
        rehearsal.best_against(open ? a.rivals : std::vector<Hypothesis>{a.without});
    if (!choice || choice->deviance < telling) continue;
    f.next_motion = choice->motion;
    f.next_experiment = words_for(choice->motion) + ": " + expectation(choice->deviance, open);
  }
}

/// Of the terms that the model already had.
std::vector<ParameterEstimate> numbers_of(std::vector<ParameterEstimate> parameters,
                                          const Model& given) {
  std::erase_if(parameters, [&](const auto& p) { return !given.has(p.effect); });
  return parameters;
}

bool asserts(const Diagnosis& out, const std::string& effect) {
  return std::ranges::any_of(out.findings, [&](const Finding& f) {
    return std::ranges::any_of(f.parameters, [&](const auto& p) { return p.effect == effect; });
  });
}

/// The model that is handed on holds what is asserted. What was taken back must not leave its mark
/// on the numbers of what stays: they are fitted anew without it. Returns what was kept.
Hypothesis settle_numbers(const Bench& bench, const Hypothesis& final, const Model& given,
                          Diagnosis& out) {
  Hypothesis kept = final;
  const auto taken_back = [&](const Piece& p) {
    return p.effect && !given.has(p.effect->name()) && !asserts(out, p.effect->name());
  };
  if (std::erase_if(kept, taken_back) == 0) return kept;
  kept = polish(bench, std::move(kept));
  const Fit fit = bench.fit(kept);
  out.extended = model_of(bench, kept, fit, fit.solution.coefficients, given);
  const auto parameters = estimate_parameters(bench, kept, fit, given);
  out.numbers = numbers_of(parameters, given);
  for (Finding& f : out.findings)
    for (ParameterEstimate& p : f.parameters)
      for (const auto& now : parameters)
        if (now.effect == p.effect && now.name == p.name) p = now;
  return kept;
}

}  // namespace

Stated state_findings(const Bench& bench, const Account& account, const PathResiduals& after,
                      const Model& given, std::size_t atoms, Diagnosis& out) {
  const Hypothesis& final = account.final.hypothesis;
  const Fit fit = bench.fit(final);
  out.extended = model_of(bench, final, fit, fit.solution.coefficients, given);
  const auto parameters = estimate_parameters(bench, final, fit, given);
  out.numbers = numbers_of(parameters, given);
  for (const auto& a : account.assessments)
    out.findings.push_back(finding(bench, account, after, a, parameters, out));
  propose(bench, account, out);
  out.unexplained = nameless(bench, final, after, atoms, out);
  for (const auto look : {wanders, blows, loud_while})
    if (!out.unexplained && bench.method().looks_for_nameless) out.unexplained = look(bench, final);
  doubt_beside_unexplained(out);
  if (bench.method().looks_for_nameless) withdraw_contradicted(account, out);
  Stated stated;
  stated.zero_nm = settle_offsets(bench, final, fit, out);
  merge_late(out);
  leave_to_the_clock(bench, out);
  std::ranges::stable_sort(out.findings, std::greater{}, &Finding::probability);
  stated.asserted = settle_numbers(bench, final, given, out);
  std::erase_if(stated.asserted, [](const Piece& p) { return p.atom != nullptr; });
  for (const std::string& name : account.near_names)
    out.undecidable.push_back({{name},
                               "explains what is left nearly as well as something without a name",
                               find_effect(name)->about().separated_by});
  for (auto& u : undecidable(bench, final))
    if (std::ranges::find(out.undecidable, u.effects, &Undecidable::effects) ==
        out.undecidable.end())
      out.undecidable.push_back(std::move(u));
  return stated;
}

}  // namespace searig::estimator
