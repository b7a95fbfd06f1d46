#include "estimator/diagnosis/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <stdexcept>

#include "estimator/diagnosis/assess.h"
#include "estimator/diagnosis/bursts.h"
#include "estimator/diagnosis/dense_map.h"
#include "estimator/diagnosis/heldout.h"
#include "estimator/diagnosis/locate.h"
#include "estimator/diagnosis/parameters.h"
#include "estimator/diagnosis/undecidable.h"
#include "estimator/diagnosis/unnamed.h"
#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

/// The paper's two equations, with numbers for the fit to find.
Model papers_model() {
  Model model;
  model.set("spring.linear", "k_nm_per_rad", 1.0);
  model.set("drive.motor", "torque_constant_nm_per_a", 1.0);
  model.set("drive.motor", "efficiency", 1.0);
  model.set("drive.inertia", "j_kg_m2", 0.0);
  return model;
}

class Diagnostician {
 public:
  Diagnostician(const Signals& signals, const std::optional<Model>& model, const Progress& progress)
      : has_model_(model.has_value()),
        given_(model ? *model : papers_model()),
        progress_(progress),
        bench_(prepare(signals, given_.get("drive.coulomb", "smoothing_rad_s").value_or(0.01))),
        dense_(dense_map(bench_.experiment().motion)),
        atoms_(unnamed_atoms(bench_.experiment().motion)),
        search_(bench_, dense_, atoms_, given_) {}

  Diagnosis run() {
    lay_base();
    tell("looking at what is left", 0.1);
    find_missing();
    tell("weighing rivals", 0.5);
    judge();
    tell("proving it on held-out blocks", 0.8);
    prove();
    conclude();
    return std::move(out_);
  }

 private:
  void tell(const std::string& doing, double share) const {
    if (progress_ && !progress_(doing, share)) throw std::runtime_error("cancelled");
  }

  void lay_base() {
    const Experiment& e = bench_.experiment();
    Hypothesis base;
    for (const auto& term : given_.terms) {
      const Effect* effect = find_effect(term.effect);
      if (effect->applies(e.motion) && has_rows(effect->path()))
        base.push_back({effect, effect->shape(term), nullptr});
      else
        out_.notes.push_back(term.effect + " is switched off: the recording lacks its channels");
    }
    if (!e.has_drive()) out_.notes.push_back("no drive path: no current with a velocity");
    if (!e.has_spring()) out_.notes.push_back("no spring path: no deflection");
    search_.learn_noise(base);
    bench_.learn_torque(base);
    search_.learn_noise(base);
    base_ = search_.score(base);
    final_ = base_;
  }

  bool has_rows(Path path) const {
    const Experiment& e = bench_.experiment();
    return path == Path::drive ? e.has_drive() : path != Path::spring || e.has_spring();
  }

  void find_missing() {
    std::vector<Step> trail;
    const Scored named = search_.add_named(base_, trail);
    final_ = named;
    const Step& last = trail.back();
    const bool rest_has_no_name =
        !last.unnamed.empty() && search_.stands_out(last.unnamed.front(), last.before);
    if (!rest_has_no_name) return;
    // Something without a name is there. Did it push a wrong name forward? Let both kinds compete
    // from the start, and keep whichever account is the better one.
    tell("something is left that has no name", 0.35);
    const Scored beside = search_.add_unnamed(named, 3);
    const Scored rivals = search_.add_either(base_, 4);
    search_.learn_noise(beside.hypothesis);  // to compare them under one noise
    final_ = search_.score(rivals.hypothesis).cost() < search_.score(beside.hypothesis).cost()
                 ? rivals
                 : beside;
    refine_atoms();
  }

  /// Atoms come from a coarse grid of places; what they tell is where.
  void refine_atoms() {
    for (std::size_t i = 0; i < final_.hypothesis.size(); ++i) {
      if (!final_.hypothesis[i].atom) continue;
      Hypothesis rest = final_.hypothesis;
      rest.erase(rest.begin() + std::ptrdiff_t(i));
      refined_.push_back(refined(bench_, rest, *final_.hypothesis[i].atom));
      final_.hypothesis[i].atom = &refined_.back();
    }
  }

  bool in_base(const Piece& piece) const {
    return std::ranges::any_of(base_.hypothesis, [&](const Piece& p) {
      return p.effect == piece.effect && p.shape.size() == piece.shape.size();
    });
  }

  /// Drops named pieces that do not hold once everything is in place, and lets rivals that fit
  /// better in their place take it.
  void judge() {
    search_.learn_noise(final_.hypothesis);
    final_ = search_.score(final_.hypothesis);
    for (int changes = 0; changes < 6; ++changes)
      if (!change_one()) return;
  }

  bool change_one() {
    assessments_.clear();
    for (std::size_t i = 0; i < final_.hypothesis.size(); ++i) {
      const Piece piece = final_.hypothesis[i];
      if (piece.atom || in_base(piece)) continue;
      Assessment a = assess(search_, bench_, final_, i);
      const bool weak =
          a.gain < search_.criteria().least_gain || a.rho < search_.criteria().least_rho;
      if (!weak && !a.better) {
        assessments_.push_back(std::move(a));
        continue;
      }
      final_ = a.better ? *a.better : search_.score(a.without);
      return true;
    }
    return false;
  }

  /// Held-out residuals of a hypothesis.
  PathErrors errors(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                    const Eigen::VectorXd& given, double noise) const {
    PathErrors out;
    if (has_model_) out.as_given = rms_of(given);
    out.before = rms_of(before);
    out.after = rms_of(after);
    out.noise_floor = noise;
    return out;
  }

  void prove() {
    const Experiment& e = bench_.experiment();
    const PathResiduals before = heldout_residuals(bench_, base_.hypothesis);
    const PathResiduals after = heldout_residuals(bench_, final_.hypothesis);
    std::vector<Eigen::VectorXd> amplitudes;
    for (const auto& piece : base_.hypothesis)
      amplitudes.push_back(piece.effect->amplitudes(*given_.find(piece.effect->name()), given_));
    const PathResiduals given = given_residuals(bench_, base_.hypothesis, amplitudes);
    const Eigen::VectorXd left =
        bench_.raw_residual(final_.hypothesis, bench_.fit(final_.hypothesis));
    if (e.has_spring())
      out_.spring =
          errors(before.spring, after.spring, given.spring, usable_rms(left, 0, e.loadcell_rows()));
    if (e.has_drive())
      out_.drive = errors(before.drive, after.drive, given.drive,
                          usable_rms(left, e.loadcell_rows(), e.rows()));
    const auto keep = [](const Eigen::VectorXd& x) {
      return std::vector<double>(x.begin(), x.end());
    };
    std::vector<double> t_s = e.loadcell_t;
    for (double& t : t_s) t += e.start_s;
    out_.traces = {t_s,
                   keep(e.loadcell_nm),
                   keep(before.spring),
                   keep(after.spring),
                   keep(before.drive),
                   keep(after.drive)};
    out_.map = map_of(bench_, dense_, base_.hypothesis, final_.hypothesis);
  }

  double usable_rms(const Eigen::VectorXd& raw, Eigen::Index from, Eigen::Index to) const {
    double sum = 0.0;
    Eigen::Index n = 0;
    for (Eigen::Index i = from; i < to; ++i)
      if (bench_.experiment().usable[std::size_t(i)]) sum += raw[i] * raw[i], ++n;
    return n > 0 ? std::sqrt(sum / double(n)) : 0.0;
  }

  void conclude() {
    const Fit fit = bench_.fit(final_.hypothesis);
    out_.extended = model_of(bench_, final_.hypothesis, fit, fit.solution.coefficients, given_);
    const auto parameters = estimate_parameters(bench_, final_.hypothesis, fit, given_);
    for (const auto& a : assessments_) out_.findings.push_back(finding(a, parameters));
    std::ranges::stable_sort(out_.findings, std::greater{}, &Finding::probability);
    for (const auto& p : parameters)
      if (given_.has(p.effect)) out_.numbers.push_back(p);
    unexplained();
    for (const auto look : {wanders, blows, loud_while})
      if (!out_.unexplained) out_.unexplained = look(bench_, final_.hypothesis);
    doubt_beside_unexplained();
    withdraw_doubtful();
    settle_offsets(fit);
    merge_late();
    for (auto& u : undecidable(bench_, final_.hypothesis)) out_.undecidable.push_back(std::move(u));
    out_.verdict = verdict();
  }

  Finding finding(const Assessment& a, const std::vector<ParameterEstimate>& parameters) const {
    const Piece& piece = final_.hypothesis[a.piece];
    Finding f;
    f.effect = piece.effect->name();
    f.probability = a.probability;
    f.alternatives = a.alternatives;
    for (const auto& p : parameters)
      if (p.effect == f.effect) f.parameters.push_back(p);
    f.located = locate(bench_, a.without, final_.hypothesis, piece.effect->path(),
                       piece.effect->about().channel);
    const PathResiduals without = heldout_residuals(bench_, a.without);
    const PathResiduals with = heldout_residuals(bench_, final_.hypothesis);
    const bool drive = piece.effect->path() == Path::drive || !out_.spring;
    f.before_nm = rms_of(drive ? without.drive : without.spring);
    f.after_nm = rms_of(drive ? with.drive : with.spring);
    const PathErrors& whole = drive ? *out_.drive : *out_.spring;
    const double floor = std::min(whole.after, whole.noise_floor);
    f.located.share = std::clamp((f.before_nm * f.before_nm - f.after_nm * f.after_nm) /
                                     std::max(1e-30, f.before_nm * f.before_nm - floor * floor),
                                 0.0, 1.0);
    f.next_experiment = piece.effect->about().separated_by;
    return f;
  }

  /// An atom that is local says itself where.
  void place(const Atom& atom, Located& located) const {
    const double start = bench_.experiment().start_s;
    if (atom.at_once)
      located.intervals_s = {{start + atom.from - 0.5, start + atom.from + 0.5}};
    else if (atom.at && atom.channel == "time_s")
      located.intervals_s = {{start + atom.from, start + atom.to}};
    else if (atom.at)
      located.regions = {{atom.channel, atom.from, atom.to}};
    if (atom.channel == "time_s") located.regions.clear();
  }

  /// Atoms in the final hypothesis are the mismatch that has no name.
  void unexplained() {
    Hypothesis without = final_.hypothesis;
    std::vector<const Atom*> atoms;
    std::erase_if(without, [&](const Piece& p) {
      if (p.atom) atoms.push_back(p.atom);
      return p.atom != nullptr;
    });
    if (atoms.empty()) return;
    Unexplained u;
    u.located =
        locate(bench_, without, final_.hypothesis, atoms.front()->path, atoms.front()->channel);
    u.what = atoms.front()->what;
    place(*atoms.front(), u.located);
    const bool drive = atoms.front()->path == Path::drive;
    const auto before = heldout_residuals(bench_, without);
    const auto after = heldout_residuals(bench_, final_.hypothesis);
    const double b = rms_of(drive ? before.drive : before.spring);
    const double a = rms_of(drive ? after.drive : after.spring);
    u.located.share = std::clamp(1.0 - a * a / (b * b), 0.0, 1.0);
    u.p_value = 0.001;  // the atoms passed the search's own null, see Criteria
    out_.unexplained = u;
  }

  /// Where something without a name is left in the same residuals, and it is not small beside a
  /// finding, the name may be the nearest one only. A straight drift under a wandering zero is
  /// void.
  void doubt_beside_unexplained() {
    if (!out_.unexplained) return;
    const auto& left = out_.unexplained->located;
    for (auto& f : out_.findings)
      if (f.located.residuals == left.residuals && left.share > 0.1 * f.located.share)
        f.probability *= 0.65;
    if (out_.unexplained->what == "the load cell's zero wanders")
      std::erase_if(out_.findings, [](const Finding& f) { return f.effect == "rig.zero_drift"; });
  }

  /// What is as likely nameless, or contradicts itself between the residuals, is not asserted.
  void withdraw_doubtful() {
    std::erase_if(out_.findings, [&](const Finding& f) {
      const auto a = std::ranges::find_if(assessments_, [&](const Assessment& x) {
        return final_.hypothesis[x.piece].effect->name() == f.effect;
      });
      const bool nameless_as_likely = !f.alternatives.empty() &&
                                      f.alternatives.front().effect.empty() &&
                                      f.alternatives.front().probability >= f.probability;
      if (a->consistent && !nameless_as_likely) return false;
      if (!out_.unexplained)
        out_.unexplained =
            Unexplained{f.located, 0.001,
                        a->consistent ? "as likely something without a name as " + f.effect
                                      : "the residuals disagree about " + f.effect};
      return true;
    });
  }

  /// A constant between drive and spring is a current offset, or one of the deflection (a number,
  /// not physics). With the load cell's own zero free, only parsimony tells: the one that leaves
  /// the load cell's zero at nothing.
  void settle_offsets(const Fit& fit) {
    const auto found = std::ranges::find(out_.findings, "drive.current_offset", &Finding::effect);
    const Eigen::Index zero = fit.columns.cols() - bench_.nuisance_count();
    const double loadcell = fit.solution.coefficients[zero];
    const double loadcell_sd = 3.0 * fit.solution.sd[zero];
    offset_nm_ = std::abs(loadcell) > std::max(loadcell_sd, 0.003 * bench_.experiment().torque_rms)
                     ? loadcell
                     : 0.0;
    if (found == out_.findings.end()) return;
    double drive = 0.0;
    for (std::size_t i = 0; i < final_.hypothesis.size(); ++i)
      if (final_.hypothesis[i].effect && final_.hypothesis[i].effect->name() == found->effect)
        drive = fit.amplitudes(i)[0];
    const double tolerance = std::max(loadcell_sd, 0.15 * std::abs(drive));
    if (std::abs(loadcell) <= tolerance) return;
    const bool deflection = std::abs(loadcell - drive) <= tolerance;
    out_.findings.erase(found);
    std::erase_if(out_.extended.terms,
                  [](const Term& t) { return t.effect == "drive.current_offset"; });
    offset_nm_ = loadcell;
    if (deflection) {
      out_.notes.push_back("the deflection has an offset: a number, to be tared");
      return;
    }
    out_.undecidable.push_back(
        {{"drive.current_offset"},
         "load cell, deflection and current disagree by constants; two of the "
         "three are off, and no recording tells which",
         "readings at rest, unloaded, with the motor switched off"});
  }

  /// Delay and lag are one finding: the load cell answers late. The larger time names it.
  void merge_late() {
    const auto delay = std::ranges::find(out_.findings, "rig.delay", &Finding::effect);
    const auto lag = std::ranges::find(out_.findings, "rig.lag", &Finding::effect);
    if (delay == out_.findings.end() || lag == out_.findings.end()) return;
    const bool lag_names = lag->parameters[0].value > std::abs(delay->parameters[0].value);
    Finding &kept = lag_names ? *lag : *delay, &other = lag_names ? *delay : *lag;
    kept.probability = std::max(kept.probability, other.probability);
    kept.parameters.insert(kept.parameters.end(), other.parameters.begin(), other.parameters.end());
    out_.findings.erase(lag_names ? delay : lag);
  }

  Verdict verdict() const {
    if (!out_.findings.empty()) return Verdict::missing_physics;
    if (out_.unexplained) return Verdict::unexplained;
    if (!has_model_) return Verdict::recalibrate;
    return numbers_hold() && offset_nm_ == 0.0 ? Verdict::consistent : Verdict::recalibrate;
  }

  /// Whether each given number lies within its interval, widened by one percent for what filters
  /// and sampling do to any number.
  bool numbers_hold() const {
    return std::ranges::all_of(out_.numbers, [&](const ParameterEstimate& p) {
      const auto given = given_.get(p.effect, p.name);
      if (!given) return true;
      const double half = 1.5 * (p.upper - p.value) + 0.01 * std::abs(p.value);
      return std::abs(*given - p.value) <= half;
    });
  }

  bool has_model_;
  Model given_;
  const Progress& progress_;
  Bench bench_;
  std::vector<Atom> dense_, atoms_;
  Search search_;
  Scored base_, final_;
  std::vector<Assessment> assessments_;
  std::deque<Atom> refined_;  // atoms of final_ that were moved; addresses stay
  double offset_nm_ = 0.0;    // of the load cell, where it is one
  Diagnosis out_;
};

}  // namespace

Diagnosis diagnose(const Signals& signals, const std::optional<Model>& model,
                   const Progress& progress) {
  return Diagnostician(signals, model, progress).run();
}

}  // namespace searig::estimator
