// searig import: a recording folder, an export or a module's own log as one file.
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include "acquisition/error.h"
#include "acquisition/exchange/import.h"
#include "acquisition/recording/mcap/import.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/new_mcap.h"
#include "app/session/read_with_model.h"
#include "app/session/stream_facts.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;
namespace exchange = acquisition::exchange;
using acquisition::Recording;
using exchange::Kind;

struct Options {
  fs::path path, out;
  std::string json;
  std::optional<std::size_t> module;
  std::optional<double> gear_ratio;
};

Recording read(const Options& options, Kind kind) {
  if (acquisition::mcap::is_mcap(options.path))
    throw acquisition::InputError(options.path.string() +
                                  ": is one file already; there is nothing to do.");
  Recording recording = kind == Kind::recording ? read_with_model(options.path)
                                                : exchange::read_any(options.path, options.module);
  recording.gear_ratio = options.gear_ratio.value_or(recording.gear_ratio);
  return recording;
}

/// An export holds nothing that the recording does not; other files are kept as they are.
std::vector<fs::path> originals(const Recording& recording, Kind kind) {
  if (kind == Kind::recording) return acquisition::mcap::originals_of(recording);
  if (kind == Kind::hebilog) return {recording.path};
  return {};
}

nlohmann::json answer(const Recording& recording, const Options& options) {
  nlohmann::json out{{"format", "searig-import/1"},
                     {"file", options.out.string()},
                     {"streams", {stream_json(recording.module), stream_json(recording.loadcell)}},
                     {"model", !recording.model_toml.empty()}};
  for (const auto& device : recording.devices) out["streams"].push_back(stream_json(device.stream));
  return out;
}

void say(const Recording& recording, const Options& options, Kind kind) {
  std::cout << stream_line(recording.module) << '\n';
  if (!recording.loadcell.t_s.empty()) std::cout << stream_line(recording.loadcell) << '\n';
  for (const auto& device : recording.devices) std::cout << stream_line(device.stream) << '\n';
  for (const auto& event : recording.events)
    if (kind == Kind::hebilog) std::cout << event.text << '\n';
  if (kind == Kind::hebilog && !options.gear_ratio)
    std::cout << "The log does not hold the gear ratio, which is taken to be 1; --gear-ratio says "
                 "it.\n";
  std::cout << options.out.string() << ": every number as it was"
            << (originals(recording, kind).empty() ? "\n" : ", the files themselves attached\n");
}

void run(const Options& options) {
  const Kind kind = exchange::kind_of(options.path);
  const Recording recording = read(options, kind);
  new_mcap(options.out, [&](const acquisition::mcap::Writer::Sink& sink) {
    acquisition::mcap::write_mcap(recording, originals(recording, kind), "searig " SEARIG_VERSION,
                                  sink);
  });
  give(
      options.json, [&] { say(recording, options, kind); },
      [&] { return answer(recording, options); });
}

}  // namespace

void add_import(CLI::App& app) {
  auto* command =
      app.add_subcommand("import", "Make one .mcap file of a folder, an export or a HEBI log");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("PATH", options->path,
                   "Folder with a recording.toml; what searig export wrote (csv --long, mat, "
                   "hdf5); or a .hebilog")
      ->required();
  command->add_option("--out", options->out, "File to make")->required();
  command->add_option("--module", options->module,
                      ".hebilog: which module, where it holds several");
  command
      ->add_option("--gear-ratio", options->gear_ratio,
                   "Motor turns for one of the output; in place of what the recording says")
      ->check(CLI::PositiveNumber);
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer(
      "Examples:\n  searig import my_recording --out my_recording.mcap\n"
      "  searig import arm.hebilog --gear-ratio 272.222 --out arm.mcap");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
