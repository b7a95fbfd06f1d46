// searig diagnose: where recording and simulation differ, what physics is missing, and what it
// brings.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "acquisition/recording/text_file.h"
#include "app/cli/commands.h"
#include "app/cli/in_parallel.h"
#include "app/cli/json_output.h"
#include "app/cli/progress_line.h"
#include "app/report/diagnosis_json.h"
#include "app/report/diagnosis_report.h"
#include "app/report/diagnosis_words.h"
#include "app/session/examine.h"
#include "app/session/motion_spec.h"

namespace searig::app {
namespace {

struct Options {
  std::vector<std::string> recordings;
  std::optional<std::string> model;
  std::string json, report, write_model, write_experiment;
  std::string control;
  bool each = false;
  unsigned jobs = 0;
};

/// One diagnosis, or why there is none.
struct Outcome : Examined {
  std::string name;
  std::string failure;
};

void note_model_of_others(const Options& options, Outcome& outcome) {
  for (std::size_t i = 1; i < options.recordings.size() && !options.model; ++i) {
    const auto other = find_model(options.recordings[i], {});
    const auto text = [](const std::optional<estimator::Model>& m) {
      return m ? estimator::to_toml(*m) : std::string();
    };
    if (text(other) == text(outcome.given)) continue;
    outcome.diagnosis.notes.push_back("the recordings come with different models; that of " +
                                      outcome.parts.front().name + " is held against all");
    return;
  }
}

const char* const no_noise_model = "no-noise-model";
const char* const no_adequacy_test = "no-adequacy-test";
const char* const adapting_stiffness = "adapting-stiffness";

estimator::Method method_of(const std::string& control) {
  return {control != no_noise_model, control != no_adequacy_test, control != adapting_stiffness};
}

Outcome diagnose_together(const std::vector<std::string>& recordings, const Options& options,
                          const estimator::Progress& progress) {
  std::vector<Session> sessions;
  for (const auto& recording : recordings) sessions.push_back(open_session(recording));
  std::vector<const Session*> together;
  for (const auto& session : sessions) together.push_back(&session);
  Outcome out{examine(together, find_model(recordings.front(), options.model), progress,
                      method_of(options.control)),
              {},
              {}};
  out.name = out.parts.front().name;
  return out;
}

nlohmann::json recordings_json(const Outcome& outcome) {
  nlohmann::json out = nlohmann::json::array();
  for (const Part& part : outcome.parts) {
    out.push_back({{"name", part.name}, {"from_s", part.from_s}, {"to_s", part.to_s}});
  }
  return out;
}

void say(const Outcome& outcome) {
  std::string names;
  for (const Part& part : outcome.parts) names += (names.empty() ? "" : ", ") + part.name;
  std::printf("%s\n", names.c_str());
  for (const auto& line : sentences(outcome.diagnosis, outcome.given)) {
    std::printf("  %s\n", line.c_str());
  }
  for (const auto& note : outcome.diagnosis.notes) std::printf("  Note: %s.\n", note.c_str());
}

/// The proposal for the finding that is least sure.
void write_experiment(const Outcome& outcome, const std::string& file) {
  const auto& findings = outcome.diagnosis.findings;
  const auto open = std::find_if(findings.rbegin(), findings.rend(),
                                 [](const auto& f) { return f.next_motion.has_value(); });
  if (open == findings.rend())
    throw std::runtime_error(file + " is not written: no motion would tell more here");
  acquisition::write_text_file(file, to_toml(*open->next_motion, outcome.diagnosis.extended));
}

void run_together(const Options& options) {
  Outcome outcome;
  {
    ProgressLine line;
    outcome = diagnose_together(options.recordings, options,
                                [&line](const std::string& doing, double share) {
                                  line.say(doing, share);
                                  return true;
                                });
  }
  note_model_of_others(options, outcome);
  if (options.json != "-") say(outcome);
  if (!options.json.empty()) {
    nlohmann::json answer = to_json(outcome.diagnosis, outcome.given);
    answer["format"] = "searig-diagnosis/1";
    answer["recordings"] = recordings_json(outcome);
    write_json(answer, options.json);
  }
  if (!options.report.empty()) diagnosis_report(outcome).write(options.report);
  if (!options.write_model.empty()) {
    acquisition::write_text_file(options.write_model, to_toml(outcome.diagnosis.extended));
  }
  if (!options.write_experiment.empty()) write_experiment(outcome, options.write_experiment);
}

/// Each by itself. One bad recording does not keep the others from their answer, but the exit code
/// tells of it.
void run_each(const Options& options) {
  std::vector<Outcome> outcomes(options.recordings.size());
  in_parallel(outcomes.size(), options.jobs, [&](std::size_t i) {
    try {
      outcomes[i] = diagnose_together({options.recordings[i]}, options, {});
    } catch (const std::exception& error) {
      outcomes[i].failure = error.what();
      outcomes[i].name = options.recordings[i];
    }
  });
  nlohmann::json answers = nlohmann::json::array(), failed = nlohmann::json::array();
  for (const Outcome& outcome : outcomes) {
    if (!outcome.failure.empty()) {
      std::fprintf(stderr, "searig: %s: %s\n", outcome.name.c_str(), outcome.failure.c_str());
      failed.push_back({{"name", outcome.name}, {"why", outcome.failure}});
      continue;
    }
    if (options.json != "-") say(outcome);
    answers.push_back(to_json(outcome.diagnosis, outcome.given));
    answers.back()["name"] = outcome.name;
  }
  if (!options.json.empty()) {
    write_json({{"format", "searig-diagnosis/1"}, {"recordings", answers}, {"failed", failed}},
               options.json);
  }
  if (!failed.empty()) {
    throw std::runtime_error(std::to_string(failed.size()) + " of " +
                             std::to_string(outcomes.size()) +
                             " recordings could not be diagnosed");
  }
}

}  // namespace

void add_diagnose(CLI::App& app) {
  auto* command = app.add_subcommand(
      "diagnose", "Where recording and simulation differ, and what physics is missing");
  const auto options = std::make_shared<Options>();
  command
      ->add_option(
          "RECORDING", options->recordings,
          "Folders with a recording.toml, or .mcap files; several are explained by one model")
      ->required();
  command->add_option("--model", options->model,
                      "The simulation, instead of the recording's own model.toml");
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  auto* report = command->add_option("--report", options->report,
                                     "Write a report with pictures as one HTML file");
  auto* model = command->add_option("--write-model", options->write_model,
                                    "Write the model with what was missing, as a model file");
  auto* experiment = command->add_option(
      "--write-experiment", options->write_experiment,
      "Write the motion that would settle most, as a spec for the rig and for searig simulate");
  auto* each =
      command->add_flag("--each", options->each, "Diagnose each recording by itself instead");
  each->excludes(model);
  each->excludes(report);
  each->excludes(experiment);
  command->add_option("--jobs", options->jobs,
                      "With --each, recordings at the same time (0: one per core)");
  command
      ->add_option("--control", options->control,
                   "Leave part of the method out, to see what it is worth (docs/proving.md)")
      ->check(CLI::IsMember({no_noise_model, no_adequacy_test, adapting_stiffness}));
  command->footer(
      "Example:\n  searig diagnose my_recording --json answer.json --report report.html "
      "--write-model better.toml");
  command->callback([options] { options->each ? run_each(*options) : run_together(*options); });
}

}  // namespace searig::app
