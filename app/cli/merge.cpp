// searig merge: the shards of one batch into the answer that one machine would have given.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/batch/journal.h"
#include "app/batch/merge.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<fs::path> shards;
  fs::path out;
  std::string json;
};

void run(const Options& options) {
  if (fs::exists(options.out / journal_name))
    throw std::runtime_error(options.out.string() +
                             ": holds a batch of its own; --out takes another folder.");
  const Summary summary = merge_shards(options.shards);
  write_summary(summary, options.out);
  if (options.json != "-")
    std::printf("%zu recordings of %zu shards: %s\n", summary.answers.size(), options.shards.size(),
                (options.out / "report.html").c_str());
  if (!options.json.empty()) write_json(answer_of(summary), options.json);
}

}  // namespace

void add_merge(CLI::App& app) {
  auto* command = app.add_subcommand("merge", "Puts the shards of a batch together");
  const auto options = std::make_shared<Options>();
  command->add_option("DIR", options->shards, "The folders that --shard ... --out DIR filled")
      ->required();
  command->add_option("--out", options->out, "Folder for summary.csv, report.html and JSON")
      ->required();
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer(
      "Example:\n  searig evaluate recordings --shard 1/2 --out shard-1   # on one machine\n"
      "  searig evaluate recordings --shard 2/2 --out shard-2   # on another\n"
      "  searig merge shard-1 shard-2 --out merged");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
