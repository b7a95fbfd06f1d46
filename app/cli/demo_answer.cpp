// What the demo found, in a few lines for people and as JSON for machines.
#include "app/cli/demo_report.h"
#include "app/report/axis.h"

namespace searig::app {
namespace {

using estimator::Evaluation;

std::string percent(const char* name, const estimator::Score& score) {
  return std::string(name) + " " + number(score.error_percent, 1) + " %";
}

std::string errors_of(const Evaluation& evaluation) {
  std::string words;
  if (evaluation.online) words += percent("online", evaluation.online->score);
  if (evaluation.current) words += ", " + percent("motor current", evaluation.current->score);
  return words;
}

}  // namespace

std::vector<std::string> describe(const Session& session, const DemoResult& result) {
  const auto& clock = session.clock;
  std::vector<std::string> lines;
  lines.push_back(std::string("Clocks: ") + (clock.trusted ? "trusted" : "NOT TRUSTED") +
                  ", load cell to module within ±" + number(1e3 * clock.ci95_s, 1) + " ms.");
  if (const auto& online = result.poor_start.online) {
    lines.push_back("Stiffness: from " + number(online->initial_k_nm_per_rad, 0) + " to " +
                    number(online->k_nm_per_rad, 1) + " N·m/rad; the simulated spring has " +
                    number(result.truth_nm_per_rad.back(), 1) + " now.");
  }
  std::string errors = "Torque error: ";
  if (const auto& fit = result.good_start.best_fit)
    errors += percent("best fit", fit->score) + ", ";
  lines.push_back(errors + errors_of(result.good_start) + ".");
  lines.push_back(
      "  by the paper's drive model, without friction: " + errors_of(result.bare_drive) + ".");
  return lines;
}

nlohmann::json to_json(const Session& session, const DemoResult& result) {
  const auto score = [](const estimator::Score& s) {
    return nlohmann::json{{"error_percent", s.error_percent}, {"rmse_nm", s.rmse_nm}};
  };
  nlohmann::json models;
  if (const auto& fit = result.good_start.best_fit) {
    models["best_fit"] = score(fit->score);
    models["best_fit"]["k_nm_per_rad"] = fit->k_nm_per_rad;
  }
  const auto online = [&](const char* name, const Evaluation& evaluation) {
    if (!evaluation.online) return;
    models[name] = score(evaluation.online->score);
    models[name]["k_nm_per_rad"] = evaluation.online->k_nm_per_rad;
  };
  online("online", result.good_start);
  online("online_ten_times_too_high", result.poor_start);
  if (const auto& current = result.good_start.current) models["current"] = score(current->score);
  nlohmann::json pictures = nlohmann::json::array();
  for (const auto& picture : result.pictures) pictures.push_back(picture.string());
  return {{"format", "searig-demo/1"},
          {"recording", result.recording.string()},
          {"report", result.report.string()},
          {"pictures", pictures},
          {"seconds", result.good_start.seconds},
          {"true_stiffness_nm_per_rad", result.truth_nm_per_rad.back()},
          {"loadcell_to_module",
           {{"rate", session.clock.rate},
            {"offset_s", session.clock.offset_s},
            {"ci95_s", session.clock.ci95_s},
            {"error_s", result.clock_error_s},
            {"trusted", session.clock.trusted}}},
          {"models", models}};
}

}  // namespace searig::app
