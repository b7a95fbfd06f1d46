#include "estimator/diagnosis/answer/findings.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "estimator/diagnosis/answer/doubt.h"
#include "estimator/diagnosis/answer/locate.h"
#include "estimator/diagnosis/answer/nameless.h"
#include "estimator/diagnosis/answer/next_experiment.h"
#include "estimator/diagnosis/answer/remainder.h"
#include "estimator/diagnosis/answer/removed.h"
#include "estimator/diagnosis/answer/undecidable.h"
#include "estimator/diagnosis/fit/heldout.h"
#include "estimator/diagnosis/fit/parameters.h"
#include "estimator/diagnosis/fit/polish.h"
#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

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
        if (now.effect == p.effect && now.name == p.name) p = with_doubt_of_form(now);
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
