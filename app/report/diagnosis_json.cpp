#include "app/report/diagnosis_json.h"

namespace searig::app {
namespace {

using nlohmann::json;

json parameter_json(const estimator::ParameterEstimate& p) {
  return {{"name", p.name}, {"value", p.value}, {"ci95", {p.lower, p.upper}}};
}

json located_json(const estimator::Located& located) {
  json regions = json::array(), intervals = json::array();
  for (const auto& r : located.regions) {
    regions.push_back({{"channel", r.channel}, {"from", r.from}, {"to", r.to}});
  }
  for (const auto& [from, to] : located.intervals_s) intervals.push_back({from, to});
  return {{"residuals", located.residuals},
          {"share", located.share},
          {"regions", regions},
          {"intervals_s", intervals}};
}

json motion_json(const std::optional<estimator::PlannedMotion>& motion) {
  if (!motion) return nullptr;
  return {{"kind", estimator::name_of(motion->kind)},
          {"seconds", motion->seconds},
          {"amplitudes_rad", motion->amplitudes_rad},
          {"frequencies_hz", motion->frequencies_hz},
          {"output_rad", motion->output_rad}};
}

json finding_json(const estimator::Finding& finding) {
  json alternatives = json::array(), parameters = json::array();
  double unnamed = 0.0;
  for (const auto& a : finding.alternatives) {
    // The contract's alternatives are names; what has none is told beside them.
    if (a.effect.empty()) {
      unnamed += a.probability;
    } else {
      alternatives.push_back(
          {{"effect", a.effect}, {"probability", a.probability}, {"separated_by", a.separated_by}});
    }
  }
  for (const auto& p : finding.parameters) parameters.push_back(parameter_json(p));
  return {{"effect", finding.effect},
          {"probability", finding.probability},
          {"alternatives", alternatives},
          {"unnamed_probability", unnamed},
          {"parameters", parameters},
          {"located", located_json(finding.located)},
          {"heldout_rmse_nm", {{"before", finding.before_nm}, {"after", finding.after_nm}}},
          {"next_experiment", finding.next_experiment},
          {"next_motion", motion_json(finding.next_motion)}};
}

json path_json(const estimator::PathErrors& path) {
  json heldout = {{"before", path.before}, {"after", path.after}};
  heldout["as_given"] = path.as_given ? json(*path.as_given) : json();
  return {{"heldout_rmse_nm", heldout}, {"noise_floor_nm", path.noise_floor}};
}

json unexplained_json(const std::optional<estimator::Unexplained>& unexplained) {
  if (!unexplained) return nullptr;
  json out = located_json(unexplained->located);
  out["p_value"] = unexplained->p_value;
  out["what"] = unexplained->what;
  return out;
}

json numbers_json(const estimator::Diagnosis& diagnosis,
                  const std::optional<estimator::Model>& given) {
  json out = json::array();
  for (const auto& p : diagnosis.numbers) {
    json number = parameter_json(p);
    number["effect"] = p.effect;
    const auto was = given ? given->get(p.effect, p.name) : std::nullopt;
    number["given"] = was ? json(*was) : json();
    out.push_back(number);
  }
  return out;
}

}  // namespace

const char* name_of(estimator::Verdict verdict) {
  switch (verdict) {
    case estimator::Verdict::consistent:
      return "consistent";
    case estimator::Verdict::recalibrate:
      return "recalibrate";
    case estimator::Verdict::missing_physics:
      return "missing_physics";
    case estimator::Verdict::unexplained:
      return "unexplained";
  }
  return "";
}

json to_json(const estimator::Diagnosis& diagnosis, const std::optional<estimator::Model>& given) {
  json findings = json::array(), undecidable = json::array(), paths = json::object();
  for (const auto& f : diagnosis.findings) findings.push_back(finding_json(f));
  for (const auto& u : diagnosis.undecidable) {
    undecidable.push_back({{"effects", u.effects}, {"why", u.why}, {"needs", u.needs}});
  }
  if (diagnosis.spring) paths["spring"] = path_json(*diagnosis.spring);
  if (diagnosis.drive) paths["drive"] = path_json(*diagnosis.drive);
  json model = json::object();
  for (const auto& term : diagnosis.extended.terms) model[term.effect] = term.parameters;
  return {{"verdict", name_of(diagnosis.verdict)},
          {"findings", findings},
          {"unexplained", unexplained_json(diagnosis.unexplained)},
          {"paths", paths},
          {"undecidable", undecidable},
          {"numbers", numbers_json(diagnosis, given)},
          {"model", model},
          {"notes", diagnosis.notes}};
}

}  // namespace searig::app
