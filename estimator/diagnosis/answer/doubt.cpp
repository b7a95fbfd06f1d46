#include "estimator/diagnosis/answer/doubt.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/answer/remainder.h"

namespace searig::estimator {
namespace {

/// What is left of a probability beside something nameless in the same residuals: names of the
/// proving ground that stood there were right about two times in three.
constexpr double beside_nameless = 0.65;

}  // namespace

void doubt_beside_unexplained(Diagnosis& out) {
  if (!out.unexplained) return;
  const auto& left = out.unexplained->located;
  for (auto& f : out.findings)
    if (f.located.residuals == left.residuals && left.share > 0.1 * f.located.share)
      f.probability *= beside_nameless;
  if (out.unexplained->what == zero_wanders || out.unexplained->what == zero_jumps)
    std::erase_if(out.findings, [](const Finding& f) { return f.effect == "rig.zero_drift"; });
}

void withdraw_contradicted(const Account& account, Diagnosis& out) {
  std::erase_if(out.findings, [&](const Finding& f) {
    const auto a = std::ranges::find_if(account.assessments, [&](const Assessment& x) {
      return account.final.hypothesis[x.piece].effect->name() == f.effect;
    });
    if (f.effect == "drive.current_offset")
      return false;  // settle_offsets knows what constants say
    const bool nameless_as_likely = !f.alternatives.empty() &&
                                    f.alternatives.front().effect.empty() &&
                                    f.alternatives.front().probability >= f.probability;
    if (a->consistent && !nameless_as_likely) return false;
    if (a->consistent) {
      Undecidable open{{f.effect},
                       "explains the mismatch, but something without a name does so as well",
                       f.next_experiment};
      for (const Alternative& rival : f.alternatives)
        if (!rival.effect.empty()) open.effects.push_back(rival.effect);
      out.undecidable.push_back(open);
    }
    if (!out.unexplained)
      out.unexplained =
          Unexplained{f.located, 0.001,
                      a->consistent ? "as likely something without a name as " + f.effect
                                    : "the residuals disagree about " + f.effect};
    return true;
  });
}

namespace {

/// The offset of the load cell that stands out most, of those of its parts.
struct LoadcellZero {
  double nm = 0.0, tolerance_nm = 0.0;  // three standard deviations
};

LoadcellZero loadcell_zero(const Bench& bench, const Solution& solution) {
  const Eigen::Index end = solution.coefficients.size() - Bench::prior_count;
  const Eigen::Index begin = end - Eigen::Index(bench.experiment().part_starts_s.size());
  LoadcellZero out;
  double most = -1.0;
  for (Eigen::Index i = begin; i < end; ++i) {
    const double nm = solution.coefficients[i], sd = solution.sd[i];
    if (std::abs(nm) / std::max(sd, 1e-30) <= most) continue;
    most = std::abs(nm) / std::max(sd, 1e-30);
    out = {nm, 3.0 * sd};
  }
  return out;
}

}  // namespace

double settle_offsets(const Bench& bench, const Hypothesis& final, const Fit& fit, Diagnosis& out) {
  const auto found = std::ranges::find(out.findings, "drive.current_offset", &Finding::effect);
  const auto [loadcell, loadcell_tolerance] = loadcell_zero(bench, fit.solution);
  const double least = std::max(loadcell_tolerance, 0.003 * bench.experiment().torque_rms);
  const double zero_nm = std::abs(loadcell) > least ? loadcell : 0.0;
  if (found == out.findings.end()) return zero_nm;
  double drive = 0.0;
  for (std::size_t i = 0; i < final.size(); ++i)
    if (final[i].effect && final[i].effect->name() == found->effect) drive = fit.amplitudes(i)[0];
  const double tolerance = std::max(loadcell_tolerance, 0.15 * std::abs(drive));
  if (std::abs(loadcell) <= tolerance) return zero_nm;
  const bool deflection = std::abs(loadcell - drive) <= tolerance;
  out.findings.erase(found);
  std::erase_if(out.extended.terms,
                [](const Term& t) { return t.effect == "drive.current_offset"; });
  if (deflection) {
    out.notes.push_back("the deflection has an offset: a number, to be tared");
    return loadcell;
  }
  out.undecidable.push_back({{"drive.current_offset"},
                             "load cell, deflection and current disagree by constants; two of the "
                             "three are off, and no recording tells which",
                             "readings at rest, unloaded, with the motor switched off"});
  return loadcell;
}

void leave_to_the_clock(const Bench& bench, Diagnosis& out) {
  constexpr double beyond = 1.6;  // times the clock map's interval
  const double open_s = beyond * 1.96 * bench.experiment().clock_sd_s;
  std::erase_if(out.findings, [&](const Finding& f) {
    const bool late = f.effect == "rig.delay" || f.effect == "rig.lag";
    double seconds = 0.0;
    for (const auto& p : f.parameters) seconds += std::abs(p.value);
    if (!late || seconds > open_s) return false;
    out.undecidable.push_back({{"rig.delay", "rig.lag"},
                               "the load cell seems late, but by little more than its clock is "
                               "known to",
                               "a two-way ping, or a sharp knock on the lever"});
    std::erase_if(out.extended.terms, [&](const Term& t) { return t.effect == f.effect; });
    return true;
  });
}

void merge_late(Diagnosis& out) {
  const auto delay = std::ranges::find(out.findings, "rig.delay", &Finding::effect);
  const auto lag = std::ranges::find(out.findings, "rig.lag", &Finding::effect);
  if (delay == out.findings.end() || lag == out.findings.end()) return;
  const bool lag_names = lag->parameters[0].value > std::abs(delay->parameters[0].value);
  Finding &kept = lag_names ? *lag : *delay, &other = lag_names ? *delay : *lag;
  kept.probability = std::max(kept.probability, other.probability);
  kept.parameters.insert(kept.parameters.end(), other.parameters.begin(), other.parameters.end());
  out.findings.erase(lag_names ? delay : lag);
}

}  // namespace searig::estimator
