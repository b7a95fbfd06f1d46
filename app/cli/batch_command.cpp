#include "app/cli/batch_command.h"

#include <charconv>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "acquisition/recording/text_file.h"
#include "app/batch/summary.h"
#include "app/cli/json_output.h"
#include "app/cli/progress_line.h"

namespace searig::app {
namespace {

/// "3/8": from 1, at most N.
std::optional<Shard> shard_of(std::string_view text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto number = std::from_chars(text.data(), end, shard.number);
  if (number.ec != std::errc{} || number.ptr == end || *number.ptr != '/') return std::nullopt;
  const auto of = std::from_chars(number.ptr + 1, end, shard.of);
  if (of.ec != std::errc{} || of.ptr != end) return std::nullopt;
  if (shard.number < 1 || shard.number > shard.of) return std::nullopt;
  return shard;
}

/// One bad recording does not keep the others from their answer, but the exit code tells of it.
void complain(const std::vector<Outcome>& outcomes, const std::string& done) {
  const std::size_t failed = failed_of(outcomes);
  if (failed == 0) return;
  if (outcomes.size() == 1) throw std::runtime_error(outcomes.front().answer.at("why"));
  for (const Outcome& outcome : outcomes)
    if (outcome.failed())
      std::fprintf(stderr, "searig: %s: %s\n", outcome.answer.at("name").get<std::string>().c_str(),
                   outcome.answer.at("why").get<std::string>().c_str());
  throw std::runtime_error(std::to_string(failed) + " of " + std::to_string(outcomes.size()) +
                           " recordings could not be " + done);
}

void say(const std::vector<Outcome>& outcomes, const BatchOptions& options,
         const std::string& done) {
  for (const Outcome& outcome : outcomes) std::fputs(outcome.words.c_str(), stdout);
  if (!options.out) return;
  const std::size_t failed = failed_of(outcomes);
  std::printf("%zu of %zu recordings %s", outcomes.size() - failed, outcomes.size(), done.c_str());
  if (failed > 0) std::printf(", %zu failed", failed);
  std::printf(": %s\n", (std::filesystem::path(*options.out) / "report.html").c_str());
}

}  // namespace

void add_batch_options(CLI::App& command, BatchOptions& options, const std::string& recordings) {
  command.add_option("RECORDING", options.recordings, recordings);
  command.add_option("--list", options.list, "A file that names recordings, one a line");
  auto* out = command.add_option(
      "--out", options.out, "Folder for summary.csv, report.html, JSON, and what is done so far");
  command.add_flag("--resume", options.resume, "Go on with what --out holds")->needs(out);
  command
      .add_option("--shard", options.shard,
                  "I/N: only every Nth recording, from the Ith; searig merge joins them")
      ->needs(out)
      ->check(CLI::Validator(
          [](const std::string& text) {
            return shard_of(text) ? std::string() : text + " is no shard, as 3/8 is one";
          },
          "I/N"));
  command.add_option("--jobs", options.jobs, "Recordings at the same time (0: one per core)");
  command.add_option("--json", options.json, "Write the answer for machines (- for stdout)");
}

void check(const BatchOptions& options) {
  if (options.recordings.empty() && !options.list) throw CLI::RequiredError("RECORDING or --list");
}

void run_as_batch(const BatchOptions& options, const Inputs& inputs, const std::string& command,
                  nlohmann::json settings, const std::function<Outcome(const std::string&)>& work) {
  settings["program"] = "searig " SEARIG_VERSION;
  Batch batch{.command = command,
              .settings = std::move(settings),
              .recordings = inputs.recordings,
              .jobs = options.jobs,
              .out = options.out,
              .resume = options.resume};
  if (options.shard) batch.shard = *shard_of(*options.shard);
  std::vector<Outcome> outcomes;
  {
    ProgressLine line;
    outcomes = run_batch(batch, work,
                         [&](const std::string& doing, double share) { line.say(doing, share); });
  }
  const std::string done = command == "evaluate" ? "evaluated" : "diagnosed";
  Summary summary{command, {}};
  for (const Outcome& outcome : outcomes) summary.answers.push_back(outcome.answer);
  if (options.out) write_summary(summary, *options.out);
  if (options.json != "-") say(outcomes, options, done);
  if (!options.json.empty()) write_json(answer_of(summary), options.json);
  complain(outcomes, done);
}

nlohmann::json model_setting(const std::optional<std::string>& model_file) {
  if (!model_file) return nullptr;
  return acquisition::read_text_file(*model_file);
}

}  // namespace searig::app
