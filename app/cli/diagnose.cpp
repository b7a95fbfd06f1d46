// searig diagnose: where recording and simulation differ, what physics is missing, and what it
// brings.
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "acquisition/recording/text_file.h"
#include "app/cli/batch_command.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/progress_line.h"
#include "app/report/diagnosis_json.h"
#include "app/report/diagnosis_report.h"
#include "app/report/diagnosis_sentences.h"
#include "app/session/examine.h"
#include "app/session/motion_spec.h"

namespace searig::app {
namespace {

struct Options {
  BatchOptions batch;
  std::optional<std::string> model;
  std::string report, write_model, write_experiment;
  std::string control;
  bool each = false;
};

void note_model_of_others(const std::vector<std::string>& recordings, const Options& options,
                          Examined& outcome) {
  for (std::size_t i = 1; i < recordings.size() && !options.model; ++i) {
    const auto other = find_model(recordings[i], {});
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

Examined diagnose_together(const std::vector<std::string>& recordings, const Options& options,
                           const estimator::Progress& progress) {
  std::vector<Session> sessions;
  for (const auto& recording : recordings) sessions.push_back(open_session(recording));
  std::vector<const Session*> together;
  for (const auto& session : sessions) together.push_back(&session);
  return examine(together, find_model(recordings.front(), options.model), progress,
                 method_of(options.control));
}

nlohmann::json recordings_json(const Examined& outcome) {
  nlohmann::json out = nlohmann::json::array();
  for (const Part& part : outcome.parts) {
    out.push_back({{"name", part.name}, {"from_s", part.from_s}, {"to_s", part.to_s}});
  }
  return out;
}

std::string words(const Examined& outcome) {
  std::string names;
  for (const Part& part : outcome.parts) names += (names.empty() ? "" : ", ") + part.name;
  std::string out = names + "\n";
  for (const auto& line : sentences(outcome.diagnosis, outcome.given)) out += "  " + line + "\n";
  for (const auto& note : outcome.diagnosis.notes) out += "  Note: " + note + ".\n";
  return out;
}

/// The proposal for the finding that is least sure.
void write_experiment(const Examined& outcome, const std::string& file) {
  const auto& findings = outcome.diagnosis.findings;
  const auto open = std::find_if(findings.rbegin(), findings.rend(),
                                 [](const auto& f) { return f.next_motion.has_value(); });
  if (open == findings.rend())
    throw std::runtime_error(file + " is not written: no motion would tell more here");
  acquisition::write_text_file(file, to_toml(*open->next_motion, outcome.diagnosis.extended));
}

void run_together(const std::vector<std::string>& recordings, const Options& options) {
  Examined outcome;
  {
    ProgressLine line;
    outcome =
        diagnose_together(recordings, options, [&line](const std::string& doing, double share) {
          line.say(doing, share);
          return true;
        });
  }
  note_model_of_others(recordings, options, outcome);
  const std::string& json = options.batch.json;
  if (json != "-") std::fputs(words(outcome).c_str(), stdout);
  if (!json.empty()) {
    nlohmann::json answer = to_json(outcome.diagnosis, outcome.given);
    answer["format"] = "searig-diagnosis/1";
    answer["recordings"] = recordings_json(outcome);
    write_json(answer, json);
  }
  if (!options.report.empty()) diagnosis_report(outcome).write(options.report);
  if (!options.write_model.empty()) {
    acquisition::write_text_file(options.write_model, to_toml(outcome.diagnosis.extended));
  }
  if (!options.write_experiment.empty()) write_experiment(outcome, options.write_experiment);
}

Outcome diagnose_one(const std::string& recording, const Options& options) {
  const Examined examined = diagnose_together({recording}, options, {});
  nlohmann::json answer = to_json(examined.diagnosis, examined.given);
  answer["name"] = name_of(recording);
  answer["path"] = recording;
  return {answer, words(examined)};
}

void run(const Options& options) {
  check(options.batch);
  const Inputs inputs = options.batch.inputs();
  const bool each = options.each || options.batch.list || options.batch.out || inputs.searched;
  if (!each) return run_together(inputs.recordings, options);
  if (!options.report.empty() || !options.write_model.empty() || !options.write_experiment.empty())
    throw CLI::ValidationError(
        "--report, --write-model and --write-experiment are of one diagnosis; folders of "
        "recordings "
        "are diagnosed each by itself");
  run_as_batch(options.batch, inputs, "diagnose",
               {{"model", model_setting(options.model)}, {"control", options.control}},
               [&](const std::string& recording) { return diagnose_one(recording, options); });
}

}  // namespace

void add_diagnose(CLI::App& app) {
  auto* command = app.add_subcommand(
      "diagnose", "Where recording and simulation differ, and what physics is missing");
  const auto options = std::make_shared<Options>();
  add_batch_options(*command, options->batch,
                    "Folders with a recording.toml, or .mcap files; several are explained by one "
                    "model. What is found in a folder or a list is diagnosed each by itself");
  command->add_option("--model", options->model,
                      "The simulation, instead of the recording's own model.toml");
  command->add_option("--report", options->report, "Write a report with pictures as one HTML file");
  command->add_option("--write-model", options->write_model,
                      "Write the model with what was missing, as a model file");
  command->add_option(
      "--write-experiment", options->write_experiment,
      "Write the motion that would settle most, as a spec for the rig and for searig simulate");
  command->add_flag("--each", options->each, "Diagnose each recording by itself, as with --out");
  command
      ->add_option("--control", options->control,
                   "Leave part of the method out, to see what it is worth (docs/proving.md)")
      ->check(CLI::IsMember({no_noise_model, no_adequacy_test, adapting_stiffness}));
  command->footer(
      "Example:\n  searig diagnose my_recording --json answer.json --report report.html "
      "--write-model better.toml\n"
      "  searig diagnose all_recordings --out results --resume      (docs/batch.md)");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
