#include "estimator/diagnosis/diagnosis.h"

#include <algorithm>
#include <stdexcept>

#include "estimator/diagnosis/answer/findings.h"
#include "estimator/diagnosis/answer/locate.h"
#include "estimator/diagnosis/fit/heldout.h"
#include "estimator/diagnosis/fit/left.h"
#include "estimator/diagnosis/search/account.h"
#include "estimator/diagnosis/search/dense_map.h"
#include "estimator/diagnosis/search/unnamed.h"
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
  Diagnostician(const Signals& signals, const std::optional<Model>& model, const Progress& progress,
                const Method& method)
      : has_model_(model.has_value()),
        given_(model ? *model : papers_model()),
        progress_(progress),
        bench_(prepare(signals, given_.get("drive.coulomb", "smoothing_rad_s").value_or(0.01)),
               method),
        dense_(dense_map(bench_.experiment().motion)),
        atoms_(method.looks_for_nameless ? unnamed_atoms(bench_.experiment().motion)
                                         : std::vector<Atom>{}),
        search_(bench_, dense_, atoms_, given_) {}

  Diagnosis run() {
    const auto tell = [this](const std::string& doing, double share) {
      if (progress_ && !progress_(doing, share)) throw std::runtime_error("cancelled");
    };
    const Account account = find_account(bench_, search_, given_, tell);
    out_.notes = account.switched_off;
    tell("proving it on held-out blocks", 0.8);
    const PathResiduals after = prove(account);
    const Stated stated = state_findings(bench_, account, after, given_, atoms_.size(), out_);
    if (stated.asserted.size() != account.final.hypothesis.size()) prove_what_is(stated.asserted);
    out_.verdict = verdict(stated.zero_nm);
    return std::move(out_);
  }

 private:
  /// Held-out errors of one path.
  PathErrors errors(const Eigen::VectorXd& before, const Eigen::VectorXd& after,
                    const Eigen::VectorXd& given, double noise) const {
    PathErrors out;
    if (has_model_) out.as_given = rms_of(given);
    out.before = rms_of(before);
    out.after = rms_of(after);
    out.noise_floor = noise;
    return out;
  }

  /// Returns what the final hypothesis leaves on held-out blocks.
  PathResiduals prove(const Account& account) {
    const Experiment& e = bench_.experiment();
    const PathResiduals before = heldout_residuals(bench_, account.base.hypothesis);
    const PathResiduals after = heldout_residuals(bench_, account.final.hypothesis);
    Hypothesis as_given = account.base.hypothesis;
    std::vector<Eigen::VectorXd> amplitudes;
    for (auto& piece : as_given) {
      const Term& term = *given_.find(piece.effect->name());
      piece.shape = piece.effect->shape(term);
      amplitudes.push_back(piece.effect->amplitudes(term, given_));
    }
    const PathResiduals given = given_residuals(bench_, as_given, amplitudes);
    const Eigen::VectorXd left = bench_.raw_residual(account.final.hypothesis);
    if (e.has_spring())
      out_.spring =
          errors(before.spring, after.spring, given.spring, left_of(bench_, left, false).rms());
    if (e.has_drive())
      out_.drive =
          errors(before.drive, after.drive, given.drive, left_of(bench_, left, true).rms());
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
    out_.map = map_of(bench_, dense_, account.base.hypothesis, account.final.hypothesis);
    return after;
  }

  /// Errors after count what is asserted, not what was in the way of finding it.
  void prove_what_is(const Hypothesis& asserted) {
    const PathResiduals after = heldout_residuals(bench_, asserted);
    if (out_.spring) out_.spring->after = rms_of(after.spring);
    if (out_.drive) out_.drive->after = rms_of(after.drive);
    out_.traces.spring_after_nm.assign(after.spring.begin(), after.spring.end());
    out_.traces.drive_after_nm.assign(after.drive.begin(), after.drive.end());
  }

  Verdict verdict(double zero_nm) const {
    if (!out_.findings.empty()) return Verdict::missing_physics;
    if (out_.unexplained) return Verdict::unexplained;
    if (!has_model_) return Verdict::recalibrate;
    return numbers_hold() && zero_nm == 0.0 ? Verdict::consistent : Verdict::recalibrate;
  }

  bool numbers_hold() const {
    return std::ranges::all_of(out_.numbers, [&](const ParameterEstimate& p) {
      const auto given = given_.get(p.effect, p.name);
      return !given || p.allows(*given);
    });
  }

  bool has_model_;
  Model given_;
  const Progress& progress_;
  Bench bench_;
  std::vector<Atom> dense_, atoms_;
  Search search_;
  Diagnosis out_;
};

}  // namespace

Diagnosis diagnose(const Signals& signals, const std::optional<Model>& model,
                   const Progress& progress, const Method& method) {
  return Diagnostician(signals, model, progress, method).run();
}

}  // namespace searig::estimator
