#include "estimator/evaluation/drive_torque.h"

#include <cmath>
#include <string_view>

#include "estimator/evaluation/score.h"
#include "estimator/filter/paper_models.h"
#include "estimator/filter/size.h"
#include "estimator/kinematics.h"
#include "estimator/model/predict.h"

namespace searig::estimator {

namespace {

constexpr double half_width_s = 0.02;

// (2)  T_current = (tau I - J a) eta, in the contract's sign
Model paper_equation_2(const Model& model) {
  Model out;
  for (const Term& term : model.terms) {
    if (term.effect == "drive.motor" || term.effect == "drive.inertia") out.terms.push_back(term);
  }
  return out;
}

double gain_of(const Model& model) {
  return model.get("drive.motor", "torque_constant_nm_per_a").value_or(0) *
         model.get("drive.motor", "efficiency").value_or(1);
}

std::string names_of_drive_terms(const Model& model) {
  std::string names;
  for (const Term& term : model.terms) {
    if (!std::string_view(term.effect).starts_with("drive.")) continue;
    names += (names.empty() ? "" : ", ") + term.effect;
  }
  return names;
}

std::vector<double> times(double factor, std::vector<double> values) {
  for (double& value : values) value *= factor;
  return values;
}

DriveTorque from_model(const ModuleSignals& module, const Model& model, DriveTerms terms) {
  const Model used = terms == DriveTerms::paper ? paper_equation_2(model) : model;
  DriveTorque out;
  out.gain_nm_per_a = gain_of(used);
  out.nm = predict(used, module).drive_nm;
  if (!out.nm.empty()) {
    out.from = "the model's " + names_of_drive_terms(used);
    if (terms == DriveTerms::paper) out.from += " (the paper's equation 2, no friction)";
  } else {
    out.nm = times(out.gain_nm_per_a, module.current_a);
    out.from = "the model's drive.motor alone: there is no input angle for its other terms";
  }
  return out;
}

double mean_magnitude(const std::vector<double>& x) {
  double sum = 0;
  for (const double value : x) sum += std::abs(value);
  return sum / static_cast<double>(x.size());
}

// (3) at every module sample, with gamma at the size of this recording.
std::vector<double> trust_weights(const ModuleSignals& module) {
  const auto theta = differentiate(module.t_s, module.deflection_rad, half_width_s);
  const Size size{paper_size.torque_nm, mean_magnitude(theta.value), mean_magnitude(theta.first),
                  paper_size.step_s};
  const double gamma =
      PaperUnits{paper_gamma_rad2_per_s, paper_alpha, paper_beta}.scaled_to(size).gamma;
  std::vector<double> out(theta.value.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = trust_weight(theta.value[i], theta.first[i], gamma);
  }
  return out;
}

DriveTorque fitted(const Signals& signals, const std::string& source) {
  const ModuleSignals& module = signals.module;
  const LoadcellSignals& loadcell = signals.loadcell;
  const auto at_loadcell = [&](const std::vector<double>& x) {
    return sample_at(module.t_s, x, loadcell.t_s);
  };
  DriveTorque out;
  out.fitted = true;
  out.from = source + " times a constant fitted to the load cell, hence not independent of it";
  std::vector<double> weights;
  if (!module.deflection_rad.empty()) {
    weights = at_loadcell(trust_weights(module));
    out.from += "; fitted where the trust weight says that current shows torque";
  }
  const Line line = fit_line(at_loadcell(module.current_a), loadcell.torque_nm, weights);
  out.gain_nm_per_a = line.slope;
  out.offset_nm = line.offset;
  if (std::isfinite(line.slope)) out.nm = times(line.slope, module.current_a);
  return out;
}

}  // namespace

DriveTorque drive_torque(const Signals& signals, const Model* model, DriveTerms terms) {
  if (signals.module.current_a.empty()) return {};
  const bool by_loop = terms == DriveTerms::loop;
  if (!model || !model->has("drive.motor")) {
    return fitted(signals, by_loop ? "the control-loop error" : "motor current");
  }
  DriveTorque out = from_model(signals.module, *model, terms);
  if (by_loop)
    out.from = "the control-loop error times the loop's gain for the current, in " + out.from;
  return out;
}

}  // namespace searig::estimator
