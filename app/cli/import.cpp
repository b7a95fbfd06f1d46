// searig import: a recording folder as one file.
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "acquisition/error.h"
#include "acquisition/recording/mcap/import.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/recording/text_file.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/new_mcap.h"
#include "app/session/session.h"
#include "app/session/stream_facts.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path recording, out;
  std::string json;
};

/// The recording with its model in it, as one file has no folder to look for one.
acquisition::Recording recording_with_model(const fs::path& path) {
  if (acquisition::mcap::is_mcap(path))
    throw acquisition::InputError(path.string() + ": is one file already; there is nothing to do.");
  acquisition::Recording recording = acquisition::read_recording(path);
  const fs::path folder = fs::is_directory(path) ? path : path.parent_path();
  if (find_model(path, std::nullopt))
    recording.model_toml = acquisition::read_text_file(folder / "model.toml");
  return recording;
}

nlohmann::json answer(const acquisition::Recording& recording, const Options& options) {
  return {{"format", "searig-import/1"},
          {"file", options.out.string()},
          {"streams", {stream_json(recording.module), stream_json(recording.loadcell)}},
          {"model", !recording.model_toml.empty()}};
}

void run(const Options& options) {
  const acquisition::Recording recording = recording_with_model(options.recording);
  new_mcap(options.out, [&](const acquisition::mcap::Writer::Sink& sink) {
    acquisition::mcap::write_mcap(recording, acquisition::mcap::originals_of(recording),
                                  "searig " SEARIG_VERSION, sink);
  });
  if (options.json != "-") {
    std::cout << stream_line(recording.module) << '\n' << stream_line(recording.loadcell) << '\n';
    std::cout << options.out.string()
              << ": every number as it was, the files themselves attached\n";
  }
  if (!options.json.empty()) write_json(answer(recording, options), options.json);
}

}  // namespace

void add_import(CLI::App& app) {
  auto* command = app.add_subcommand("import", "Make one .mcap file of a recording folder");
  const auto options = std::make_shared<Options>();
  command->add_option("RECORDING", options->recording, "Folder with a recording.toml")->required();
  command->add_option("--out", options->out, "File to make")->required();
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer("Example:\n  searig import my_recording --out my_recording.mcap");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
