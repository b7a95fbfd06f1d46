// searig evaluate: the paper's Table I for recordings: best fit, online estimate, motor current.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/cli/commands.h"
#include "app/cli/evaluate_answer.h"
#include "app/cli/in_parallel.h"
#include "app/cli/json_output.h"
#include "app/session/session.h"
#include "estimator/evaluation/evaluation.h"
#include "estimator/physics/catalogue.h"

namespace searig::app {
namespace {

struct Options {
  std::vector<std::string> recordings;
  std::optional<std::string> model;
  std::optional<double> initial_k;
  std::string drive = "model";
  bool as_paper = false;
  std::optional<double> loop_gain;
  std::string chosen;
  std::vector<std::string> states = {"spring.linear"};
  unsigned jobs = 0;
  std::string json;

  estimator::EvaluationOptions evaluation() const {
    using enum estimator::DriveTerms;
    return {.initial_k_nm_per_rad = initial_k,
            .drive = drive == "paper"  ? paper
                     : drive == "loop" ? loop
                                       : model,
            .exactly_as_the_paper = as_paper,
            .loop_gain_a_per_rad = loop_gain,
            .estimators = estimators(),
            .states = states};
  }

  std::vector<estimator::EstimatorKind> estimators() const {
    using enum estimator::EstimatorKind;
    std::vector<estimator::EstimatorKind> out;
    for (const auto kind : {paper, moments, linear, rls}) {
      if (chosen == "all" || chosen == estimator::name_of(kind)) out.push_back(kind);
    }
    return out;
  }
};

std::string name_of(const std::string& recording) {
  const std::filesystem::path path = std::filesystem::path(recording).lexically_normal();
  if (path.extension() == ".mcap") return path.stem().string();
  return path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
}

EvaluationOutcome evaluate_one(const std::string& recording, const Options& options) {
  EvaluationOutcome out{.name = name_of(recording), .evaluation = {}, .notes = {}, .failure = {}};
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

// One bad recording does not keep the others from their answer, but the exit code tells of it.
void complain(const std::vector<EvaluationOutcome>& outcomes) {
  std::string sentence;
  std::size_t failed = 0;
  for (const EvaluationOutcome& outcome : outcomes) {
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
  std::vector<EvaluationOutcome> outcomes(options.recordings.size());
  in_parallel(outcomes.size(), options.jobs,
              [&](std::size_t i) { outcomes[i] = evaluate_one(options.recordings[i], options); });
  if (options.json != "-") {
    for (const EvaluationOutcome& outcome : outcomes) {
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
  const CLI::Validator is_state(
      [](const std::string& text) {
        const auto* effect = estimator::find_effect(text.substr(0, text.find(':')));
        const bool known = effect && effect->path() == estimator::Path::spring;
        return known ? std::string() : text + " is none of the catalogue's spring effects";
      },
      "EFFECT");
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
                   "Drive torque from all of the model's terms, from the paper's equation 2, or "
                   "with the control-loop error in place of the current")
      ->check(CLI::IsMember({"model", "paper", "loop"}));
  command
      ->add_option("--loop-gain", options->loop_gain,
                   "Of the position loop, A/rad, for --drive loop (otherwise fitted)")
      ->check(above_zero);
  command
      ->add_option("--estimator", options->chosen,
                   "Estimators to compare besides the online one (docs/estimator.md)")
      ->check(CLI::IsMember({"paper", "linear", "rls", "moments", "all"}));
  command
      ->add_option("--states", options->states,
                   "What they estimate: spring effects as the model file names them")
      ->delimiter(',')
      ->check(is_state);
  command->add_flag("--as-paper", options->as_paper,
                    "The paper's gamma, alpha and beta as printed, whatever the module's size");
  command->add_option("--jobs", options->jobs, "Recordings at the same time (0: one per core)");
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer(
      "Example:\n  searig evaluate recordings/* --initial-k 500 --json evaluation.json\n"
      "  searig evaluate RECORDING --estimator all --states spring.linear,spring.viscous");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
