#include "estimator/evaluation/drive_torque.h"

#include <cmath>
#include <string_view>

#include "estimator/evaluation/score.h"
#include "estimator/model/predict.h"

namespace searig::estimator {

namespace {

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

DriveRule from_model(const Survey& survey, const Model& model, DriveTerms terms) {
  const Model used = terms == DriveTerms::paper ? paper_equation_2(model) : model;
  DriveRule out;
  out.gain_nm_per_a = gain_of(used);
  if (survey.has_input_motion) {
    out.terms = used;
    out.from = "the model's " + names_of_drive_terms(used);
    if (terms == DriveTerms::paper) out.from += " (the paper's equation 2, no friction)";
  } else {
    out.from = "the model's drive.motor alone: there is no input angle for its other terms";
  }
  return out;
}

DriveRule fitted(const Survey& survey, const std::string& source) {
  DriveRule out;
  out.fitted = true;
  out.from = source + " times a constant fitted to the load cell, hence not independent of it";
  if (!survey.weights.empty())
    out.from += "; fitted where the trust weight says that current shows torque";
  const Line line = fit_line(survey.current_a, survey.loadcell.torque_nm, survey.weights);
  out.gain_nm_per_a = line.slope;
  out.offset_nm = line.offset;
  return out;
}

}  // namespace

bool DriveRule::usable() const {
  return !from.empty() && (!fitted || std::isfinite(gain_nm_per_a));
}

std::vector<double> DriveRule::nm(const TelemetryBlock& block) const {
  const auto part = [&](const std::vector<double>& all) {
    return std::vector<double>(all.begin() + std::ptrdiff_t(block.from),
                               all.begin() + std::ptrdiff_t(block.to));
  };
  if (terms) {
    const std::vector<double> all = predict_drive(*terms, block.rows);
    return part(all);
  }
  std::vector<double> out = part(block.rows.current_a);
  for (double& value : out) value *= gain_nm_per_a;
  return out;
}

bool fits_gain(const Model* model) {
  return !model || !model->has("drive.motor");
}

DriveRule drive_rule(const Survey& survey, const Model* model, DriveTerms terms) {
  if (!survey.has_current) return {};
  const bool by_loop = terms == DriveTerms::loop;
  if (fits_gain(model)) return fitted(survey, by_loop ? "the control-loop error" : "motor current");
  DriveRule out = from_model(survey, *model, terms);
  if (by_loop)
    out.from = "the control-loop error times the loop's gain for the current, in " + out.from;
  return out;
}

}  // namespace searig::estimator
