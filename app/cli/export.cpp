// searig export: a recording for other programs.
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "acquisition/error.h"
#include "acquisition/exchange/csv.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/progress_line.h"
#include "app/export/export_recording.h"
#include "app/session/read_with_model.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;
namespace exchange = acquisition::exchange;
using acquisition::ClockMap;
using acquisition::Recording;

constexpr const char* program = "searig " SEARIG_VERSION;

struct Options {
  std::string recording;
  std::string format = "csv";
  std::string out;
  std::string json;
  bool long_form = false;
  bool overwrite = false;
};

fs::path out_path(const Options& options, const Recording& recording) {
  const fs::path out = options.out;
  std::error_code not_there;
  if (!fs::is_directory(out, not_there)) return out;
  return out / (recording.name + (options.format == "hdf5" ? ".h5" : "." + options.format));
}

void say(const Recording& recording, const Clocks& clocks, const fs::path& out) {
  std::cout << out.string() << ": " << recording.module.t_s.size() << " samples of the module, "
            << recording.loadcell.t_s.size() << " of the load cell";
  for (const auto& device : recording.devices)
    std::cout << ", " << device.stream.t_s.size() << " of " << device.stream.name;
  std::cout << "; clocks +- " << 1e3 * clocks.loadcell.ci95_s << " ms\n"
            << out.string() << ".json: the synchronisation report and the hashes of all files\n";
  if (!clocks.loadcell.trusted) std::cout << "clocks: NOT TRUSTED: " << clocks.loadcell.why << '\n';
  if (!recording.cut_off.empty()) std::cout << recording.cut_off << '\n';
}

nlohmann::json answer(const Recording& recording, const Clocks& clocks, const std::string& out) {
  return {{"format", "searig-export/1"},
          {"file", out},
          {"module_samples", recording.module.t_s.size()},
          {"loadcell_samples", recording.loadcell.t_s.size()},
          {"clock", {{"ci95_s", clocks.loadcell.ci95_s}, {"trusted", clocks.loadcell.trusted}}}};
}

void to_stdout(const Options& options, const Recording& recording, const Clocks& clocks,
               const exchange::Contents& contents) {
  if (options.format != "csv")
    throw std::runtime_error("stdout takes csv only; a " + options.format +
                             " file is not written from front to back.");
  const exchange::Sink sink = [](std::string_view piece) { std::cout << piece; };
  options.long_form ? exchange::write_csv_long(contents, sink)
                    : exchange::write_csv_table(contents, sink);
  if (!(std::cout << std::flush)) throw std::runtime_error("stdout: cannot be written.");
  if (!options.json.empty()) write_json(answer(recording, clocks, "-"), options.json);
}

void to_file(const Options& options, const Recording& recording, const Clocks& clocks,
             const exchange::Contents& contents) {
  const fs::path out = out_path(options, recording);
  export_recording(recording, clocks, contents,
                   {options.format, options.long_form, options.overwrite}, out, program);
  if (options.json != "-") say(recording, clocks, out);
  if (!options.json.empty()) write_json(answer(recording, clocks, out.string()), options.json);
}

void run(const Options& options) {
  ProgressLine progress;
  progress.say("reading", ProgressLine::no_end);
  const Recording recording = read_with_model(options.recording);
  try {
    const Clocks clocks = clocks_of(recording);
    progress.say("writing", ProgressLine::no_end);
    const auto contents = exchange::contents_of(recording, clocks.loadcell, clocks.devices);
    options.out == "-" ? to_stdout(options, recording, clocks, contents)
                       : to_file(options, recording, clocks, contents);
  } catch (const acquisition::InputError& error) {
    throw acquisition::InputError(options.recording + ": " + error.what());
  }
}

}  // namespace

void add_export(CLI::App& app) {
  auto* command = app.add_subcommand("export", "Write a recording, on one clock, for others");
  const auto options = std::make_shared<Options>();
  command->add_option("RECORDING", options->recording, "A folder with a recording.toml, or .mcap")
      ->required();
  command->add_option("--format", options->format, "csv (the default), mat or hdf5")
      ->check(CLI::IsMember({"csv", "mat", "hdf5"}));
  command->add_option("--out", options->out, "File, or folder to put it in (- for stdout)")
      ->required();
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->add_flag("--long", options->long_form,
                    "csv: every value as received, one a row, nothing interpolated");
  command->add_flag("--overwrite", options->overwrite, "Replace what is there already");
  command->footer("Example:\n  searig export run.mcap --format mat --out run.mat");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
