#include "app/cli/evaluate_answer.h"

#include <cstdarg>
#include <cstdio>
#include <optional>

namespace searig::app {
namespace {

nlohmann::json score_json(const estimator::Score& score) {
  return {{"error_percent", score.error_percent}, {"rmse_nm", score.rmse_nm}};
}

nlohmann::json online_json(const estimator::OnlineResult& online) {
  nlohmann::json out = score_json(online.score);
  out["k_nm_per_rad"] = online.k_nm_per_rad;
  out["initial_k_nm_per_rad"] = online.initial_k_nm_per_rad;
  out["trust_weight_s"] = online.trust_weight_s;
  out["converged"] = online.convergence.has_value();
  if (online.convergence) {
    out["converged_after_s"] = online.convergence->after_s;
    out["converged_after_trust_weight_s"] = online.convergence->trust_weight_s;
  }
  return out;
}

nlohmann::json models_json(const estimator::Evaluation& evaluation) {
  nlohmann::json out = nlohmann::json::object();
  if (const auto& fit = evaluation.best_fit) {
    out["best_fit"] = score_json(fit->score);
    out["best_fit"]["k_nm_per_rad"] = fit->k_nm_per_rad;
    out["best_fit"]["offset_nm"] = fit->offset_nm;
  }
  if (evaluation.online) out["online"] = online_json(*evaluation.online);
  if (const auto& current = evaluation.current) {
    out["current"] = score_json(current->score);
    out["current"]["gain_nm_per_a"] = current->gain_nm_per_a;
    out["current"]["offset_nm"] = current->offset_nm;
    out["current"]["from"] = evaluation.drive_from;
    out["current"]["independent_of_loadcell"] = evaluation.drive_independent;
  }
  return out;
}

nlohmann::json estimator_json(const estimator::EstimatorResult& result) {
  nlohmann::json out = score_json(result.score);
  out["estimator"] = estimator::name_of(result.kind);
  out["parameters"] = nlohmann::json::array();
  for (const estimator::StateParameter& p : result.parameters) {
    nlohmann::json one = {{"effect", p.effect}, {"name", p.name}, {"value", p.value}};
    one["ci95"] = nullptr;
    if (result.why_no_interval.empty()) {
      const double half = p.half_width_95();
      one["ci95"] = {p.value - half, p.value + half};
    }
    out["parameters"].push_back(one);
  }
  if (!result.why_no_interval.empty()) out["why_no_ci95"] = result.why_no_interval;
  return out;
}

}  // namespace

nlohmann::json answer(const EvaluationOutcome& outcome) {
  nlohmann::json out = {{"name", outcome.name},
                        {"path", outcome.path},
                        {"seconds", outcome.evaluation.seconds},
                        {"models", models_json(outcome.evaluation)},
                        {"notes", outcome.notes}};
  for (const auto& result : outcome.evaluation.estimators)
    out["estimators"].push_back(estimator_json(result));
  return out;
}

namespace {

/// As printf() has it, at the end of `text`.
[[gnu::format(printf, 2, 3)]] void append(std::string& text, const char* format, ...) {
  std::va_list arguments, again;
  va_start(arguments, format);
  va_copy(again, arguments);
  const auto size = std::size_t(std::vsnprintf(nullptr, 0, format, arguments));
  const std::size_t before = text.size();
  text.resize(before + size + 1);
  std::vsnprintf(text.data() + before, size + 1, format, again);
  text.pop_back();
  va_end(again);
  va_end(arguments);
}

void say_row(std::string& out, const char* model, std::optional<double> k,
             const estimator::Score& score) {
  char text[32] = "-";
  if (k) std::snprintf(text, sizeof text, "%.4g N*m/rad", *k);
  append(out, "  %-18s %16s %9.1f %% %11.4g N*m\n", model, text, score.error_percent,
         score.rmse_nm);
}

void say_estimator(std::string& out, const estimator::EstimatorResult& result) {
  append(out, "  %-18s %28.1f %% %11.4g N*m\n", name_of(result.kind).data(),
         result.score.error_percent, result.score.rmse_nm);
  for (const estimator::StateParameter& p : result.parameters) {
    append(out, "    %-24s %12.5g", (p.effect + " " + p.name).c_str(), p.value);
    if (result.why_no_interval.empty()) append(out, " +- %.3g", p.half_width_95());
    out += "\n";
  }
}

}  // namespace

std::string words(const EvaluationOutcome& outcome) {
  std::string out;
  const estimator::Evaluation& e = outcome.evaluation;
  append(out, "%s, %.1f s\n", outcome.name.c_str(), e.seconds);
  if (e.best_fit || e.online || e.current)
    append(out, "  %-18s %16s %11s %15s\n", "Torque model", "Stiffness", "Error", "RMSE");
  if (e.best_fit) say_row(out, "Linear (best fit)", e.best_fit->k_nm_per_rad, e.best_fit->score);
  if (e.online) say_row(out, "Online", e.online->k_nm_per_rad, e.online->score);
  if (e.current) say_row(out, "Motor current", std::nullopt, e.current->score);
  if (e.online && e.online->convergence) {
    append(out,
           "  Online: from %.4g N*m/rad, within 5 %% of the best fit after %.1f s "
           "(trust weight %.2f s of %.1f s)\n",
           e.online->initial_k_nm_per_rad, e.online->convergence->after_s,
           e.online->convergence->trust_weight_s, e.online->trust_weight_s);
  } else if (e.online) {
    append(out,
           "  Online: from %.4g N*m/rad, not within 5 %% of the best fit at the end "
           "(trust weight %.1f s)\n",
           e.online->initial_k_nm_per_rad, e.online->trust_weight_s);
  }
  if (e.current) append(out, "  Motor current: %s\n", e.drive_from.c_str());
  for (const auto& result : e.estimators) say_estimator(out, result);
  for (const std::string& note : outcome.notes) append(out, "  Note: %s\n", note.c_str());
  return out;
}

}  // namespace searig::app
