// searig evaluate: the paper's Table I for recordings: best fit, online estimate, motor current.
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/cli/batch_command.h"
#include "app/cli/commands.h"
#include "app/cli/evaluate_answer.h"
#include "app/session/evaluate_recording.h"
#include "app/session/session.h"
#include "estimator/evaluation/evaluation.h"
#include "estimator/physics/catalogue.h"

namespace searig::app {
namespace {

struct Options {
  BatchOptions batch;
  std::optional<std::string> model;
  std::optional<double> initial_k;
  std::string drive = "model";
  bool as_paper = false;
  std::optional<double> loop_gain;
  std::string chosen;
  std::vector<std::string> states = {"spring.linear"};

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

Outcome evaluate_one(const std::string& recording, const Options& options, bool read_ahead) {
  EvaluatedRecording found =
      evaluate_recording(recording, options.model, options.evaluation(), read_ahead);
  const EvaluationOutcome out{.name = name_of(recording),
                              .path = recording,
                              .evaluation = std::move(found.evaluation),
                              .notes = std::move(found.notes)};
  return {answer(out), words(out)};
}

nlohmann::json settings_of(const Options& options) {
  const auto number = [](const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
  };
  return {{"model", model_setting(options.model)},
          {"initial_k", number(options.initial_k)},
          {"drive", options.drive},
          {"as_paper", options.as_paper},
          {"loop_gain", number(options.loop_gain)},
          {"estimator", options.chosen},
          {"states", options.states}};
}

void run(const Options& options) {
  check(options.batch);
  const Inputs inputs = options.batch.inputs();
  const bool alone = inputs.recordings.size() == 1 && options.batch.jobs != 1;
  run_as_batch(options.batch, inputs, "evaluate", settings_of(options),
               [&](const std::string& path) { return evaluate_one(path, options, alone); });
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
  add_batch_options(*command, options->batch,
                    "Folders with a recording.toml, .mcap files, or folders that hold such");
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
  command->footer(
      "Example:\n  searig evaluate recordings/* --initial-k 500 --json evaluation.json\n"
      "  searig evaluate RECORDING --estimator all --states spring.linear,spring.viscous\n"
      "  searig evaluate all_recordings --out results --resume      (docs/batch.md)");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
