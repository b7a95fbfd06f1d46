// searig evaluate: the paper's Table I for recordings: best fit, online estimate, motor current.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/in_parallel.h"
#include "app/cli/json_output.h"
#include "app/session/session.h"
#include "estimator/evaluation/evaluation.h"

namespace searig::app {
namespace {

struct Options {
  std::vector<std::string> recordings;
  std::optional<std::string> model;
  std::optional<double> initial_k;
  std::string drive = "model";
  bool as_paper = false;
  unsigned jobs = 0;
  std::string json;

  estimator::EvaluationOptions evaluation() const {
    return {.initial_k_nm_per_rad = initial_k,
            .drive = drive == "paper" ? estimator::DriveTerms::paper : estimator::DriveTerms::model,
            .exactly_as_the_paper = as_paper};
  }
};

/// One recording's answer, or why there is none.
struct Outcome {
  std::string name;
  estimator::Evaluation evaluation;
  std::vector<std::string> notes;
  std::string failure;
};

std::string name_of(const std::string& recording) {
  const std::filesystem::path path = std::filesystem::path(recording).lexically_normal();
  if (path.extension() == ".mcap") return path.stem().string();
  return path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
}

Outcome evaluate_one(const std::string& recording, const Options& options) {
  Outcome out{.name = name_of(recording), .evaluation = {}, .notes = {}, .failure = {}};
  try {
    const Session session = open_session(recording);
    const auto model = find_model(recording, options.model);
    out.evaluation = evaluate_session(session, model, options.evaluation());
    out.notes = out.evaluation.notes;
    if (!session.recording.cut_off.empty()) out.notes.push_back(session.recording.cut_off);
    if (!session.clock.trusted) {
      out.notes.push_back("the clocks are not to be trusted: " + session.clock.why);
    }
  } catch (const std::exception& error) {
    out.failure = error.what();
  }
  return out;
}

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

nlohmann::json answer(const std::vector<Outcome>& outcomes) {
  nlohmann::json recordings = nlohmann::json::array(), failed = nlohmann::json::array();
  for (const Outcome& outcome : outcomes) {
    if (!outcome.failure.empty()) {
      failed.push_back({{"name", outcome.name}, {"why", outcome.failure}});
      continue;
    }
    recordings.push_back({{"name", outcome.name},
                          {"seconds", outcome.evaluation.seconds},
                          {"models", models_json(outcome.evaluation)},
                          {"notes", outcome.notes}});
  }
  return {{"format", "searig-evaluation/1"}, {"recordings", recordings}, {"failed", failed}};
}

void say_row(const char* model, std::optional<double> k, const estimator::Score& score) {
  char text[32] = "-";
  if (k) std::snprintf(text, sizeof text, "%.4g N*m/rad", *k);
  std::printf("  %-18s %16s %9.1f %% %11.4g N*m\n", model, text, score.error_percent,
              score.rmse_nm);
}

void say(const Outcome& outcome) {
  const estimator::Evaluation& e = outcome.evaluation;
  std::printf("%s, %.1f s\n", outcome.name.c_str(), e.seconds);
  if (e.best_fit || e.online || e.current)
    std::printf("  %-18s %16s %11s %15s\n", "Torque model", "Stiffness", "Error", "RMSE");
  if (e.best_fit) say_row("Linear (best fit)", e.best_fit->k_nm_per_rad, e.best_fit->score);
  if (e.online) say_row("Online", e.online->k_nm_per_rad, e.online->score);
  if (e.current) say_row("Motor current", std::nullopt, e.current->score);
  if (e.online && e.online->convergence) {
    std::printf(
        "  Online: from %.4g N*m/rad, within 5 %% of the best fit after %.1f s "
        "(trust weight %.2f s of %.1f s)\n",
        e.online->initial_k_nm_per_rad, e.online->convergence->after_s,
        e.online->convergence->trust_weight_s, e.online->trust_weight_s);
  } else if (e.online) {
    std::printf(
        "  Online: from %.4g N*m/rad, not within 5 %% of the best fit at the end "
        "(trust weight %.1f s)\n",
        e.online->initial_k_nm_per_rad, e.online->trust_weight_s);
  }
  if (e.current) std::printf("  Motor current: %s\n", e.drive_from.c_str());
  for (const std::string& note : outcome.notes) std::printf("  Note: %s\n", note.c_str());
}

// One bad recording does not keep the others from their answer, but the exit code tells of it.
void complain(const std::vector<Outcome>& outcomes) {
  std::string sentence;
  std::size_t failed = 0;
  for (const Outcome& outcome : outcomes) {
    if (outcome.failure.empty()) continue;
    ++failed;
    sentence = outcome.failure;
    if (outcomes.size() > 1) {
      std::fprintf(stderr, "searig: %s: %s\n", outcome.name.c_str(), outcome.failure.c_str());
    }
  }
  if (failed == 0) return;
  if (outcomes.size() > 1) {
    sentence = std::to_string(failed) + " of " + std::to_string(outcomes.size()) +
               " recordings could not be evaluated";
  }
  throw std::runtime_error(sentence);
}

void run(const Options& options) {
  std::vector<Outcome> outcomes(options.recordings.size());
  in_parallel(outcomes.size(), options.jobs,
              [&](std::size_t i) { outcomes[i] = evaluate_one(options.recordings[i], options); });
  if (options.json != "-") {
    for (const Outcome& outcome : outcomes) {
      if (outcome.failure.empty()) say(outcome);
    }
  }
  if (!options.json.empty()) write_json(answer(outcomes), options.json);
  complain(outcomes);
}

}  // namespace

void add_evaluate(CLI::App& app) {
  auto* command = app.add_subcommand(
      "evaluate", "Best fit, online estimate and motor current against the load cell");
  const auto options = std::make_shared<Options>();
  const CLI::Validator above_zero(
      [](const std::string& text) {
        double k = 0;
        return CLI::detail::lexical_cast(text, k) && k > 0 ? "" : "must be a number above 0";
      },
      "ABOVE 0");
  command
      ->add_option("RECORDING", options->recordings,
                   "Folders with a recording.toml, or .mcap files")
      ->required();
  command->add_option("--model", options->model, "Model to use instead of the recording's own");
  command
      ->add_option("--initial-k", options->initial_k,
                   "Stiffness that the online estimate starts from, N*m/rad")
      ->check(above_zero);
  command
      ->add_option("--drive", options->drive,
                   "Drive torque from all of the model's terms, or from the paper's equation 2")
      ->check(CLI::IsMember({"model", "paper"}));
  command->add_flag("--as-paper", options->as_paper,
                    "The paper's gamma, alpha and beta as printed, whatever the module's size");
  command->add_option("--jobs", options->jobs, "Recordings at the same time (0: one per core)");
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer(
      "Example:\n  searig evaluate recordings/* --initial-k 500 --json evaluation.json");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
