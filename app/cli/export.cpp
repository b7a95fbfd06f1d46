// searig export: a recording for other programs.
#include <filesystem>
#include <functional>
#include <future>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "acquisition/error.h"
#include "acquisition/exchange/csv.h"
#include "acquisition/exchange/hdf5.h"
#include "acquisition/exchange/mat.h"
#include "acquisition/exchange/new_file.h"
#include "acquisition/exchange/sha256.h"
#include "acquisition/recorder/output_file.h"
#include "acquisition/recording/mcap/import.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/progress_line.h"
#include "app/session/read_with_model.h"
#include "app/session/sync_report.h"

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

struct Clocks {
  ClockMap loadcell;
  std::vector<ClockMap> devices;
};

Clocks clocks_of(const Recording& recording) {
  Clocks clocks{acquisition::synchronise(recording), {}};
  for (const auto& device : recording.devices)
    clocks.devices.push_back(acquisition::synchronise(recording, device));
  return clocks;
}

/// The files that a recording was read from, with their hashes.
nlohmann::json sources_of(const Recording& recording) {
  const bool one_file = acquisition::mcap::is_mcap(recording.path);
  nlohmann::json sources = nlohmann::json::array();
  for (const fs::path& file : one_file ? std::vector<fs::path>{recording.path}
                                       : acquisition::mcap::originals_of(recording))
    sources.push_back({{"file", file.string()}, {"sha256", exchange::sha256_of(file)}});
  return sources;
}

void write_csv(const exchange::Contents& contents, bool long_form, const exchange::Sink& sink) {
  long_form ? exchange::write_csv_long(contents, sink) : exchange::write_csv_table(contents, sink);
}

void write_as(const Options& options, const exchange::Contents& contents, const fs::path& file) {
  if (options.format == "mat") return exchange::write_mat(contents, program, file);
  if (options.format == "hdf5") return exchange::write_hdf5(contents, program, file);
  fs::remove(file);  // made to see whether it can be
  acquisition::OutputFile out(file);
  write_csv(contents, options.long_form, [&](std::string_view piece) { out.append(piece); });
}

/// What is refused is said of the file that was asked for, not of its temporary name.
void write_in_the_name_of(const fs::path& out, const fs::path& temporary,
                          const std::function<void()>& write) {
  try {
    write();
  } catch (const acquisition::InputError&) {
    throw;  // it is the recording's
  } catch (const std::runtime_error& error) {
    std::string words = error.what();
    if (words.starts_with(temporary.string()))
      words.replace(0, temporary.string().size(), out.string());
    throw std::runtime_error(words);
  }
}

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

/// What lies beside an export: how its clocks were found, what it was made from, what it is.
nlohmann::json sidecar(const Options& options, const Recording& recording, const Clocks& clocks,
                       const fs::path& written, const fs::path& out, nlohmann::json sources) {
  return {{"format", "searig-export-report/1"},
          {"program", program},
          {"recording", recording.name},
          {"recorded", recording.recorded},
          {"cut_off", recording.cut_off},
          {"export",
           {{"file", out.filename().string()},
            {"format", options.format},
            {"form", options.format != "csv" ? "all"
                     : options.long_form     ? "long"
                                             : "table"},
            {"bytes", fs::file_size(written)},
            {"sha256", exchange::sha256_of(written)}}},
          {"sources", std::move(sources)},
          {"sync", sync_report(recording, clocks.loadcell, clocks.devices)}};
}

void to_stdout(const Options& options, const Recording& recording, const Clocks& clocks,
               const exchange::Contents& contents) {
  if (options.format != "csv")
    throw std::runtime_error("stdout takes csv only; a " + options.format +
                             " file is not written from front to back.");
  write_csv(contents, options.long_form, [](std::string_view piece) { std::cout << piece; });
  if (!(std::cout << std::flush)) throw std::runtime_error("stdout: cannot be written.");
  if (!options.json.empty()) write_json(answer(recording, clocks, "-"), options.json);
}

void to_file(const Options& options, const Recording& recording, const Clocks& clocks,
             const exchange::Contents& contents) {
  const fs::path out = out_path(options, recording);
  exchange::NewFile file(out, options.overwrite);
  exchange::NewFile report(out.string() + ".json", options.overwrite);
  auto sources = std::async(std::launch::async, sources_of, std::cref(recording));
  write_in_the_name_of(out, file.temporary(),
                       [&] { write_as(options, contents, file.temporary()); });
  write_json(sidecar(options, recording, clocks, file.temporary(), out, sources.get()),
             report.temporary());
  file.keep();
  report.keep();
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
