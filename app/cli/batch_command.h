// What the commands that take many recordings have in common: searig evaluate, searig diagnose.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/batch/batch.h"
#include "app/batch/inputs.h"

namespace searig::app {

struct BatchOptions {
  std::vector<std::string> recordings;
  std::optional<std::string> list, out, shard;
  bool resume = false;
  unsigned jobs = 0;
  std::string json;

  Inputs inputs() const { return find_recordings(recordings, list); }
};

/// Adds them. `recordings` is what the help says of RECORDING. That there is one at all is checked
/// by check(), for --list will do.
void add_batch_options(CLI::App& command, BatchOptions& options, const std::string& recordings);

/// Throws CLI::ParseError (wrong use) where options are missing that go together.
void check(const BatchOptions& options);

/// Does the work for each recording and gives the answer in all the forms asked for: in words on
/// stdout, as JSON, as a summary in the folder. `settings` is all that decides the answers beside
/// the recordings. Throws at the end where one has failed, with a sentence for the exit code; the
/// others' answers are out by then.
void run_as_batch(const BatchOptions& options, const Inputs& inputs, const std::string& command,
                  nlohmann::json settings, const std::function<Outcome(const std::string&)>& work);

/// The text of a model file as a setting; null where none was given.
nlohmann::json model_setting(const std::optional<std::string>& model_file);

}  // namespace searig::app
