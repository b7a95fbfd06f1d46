#include "app/export/export_recording.h"

#include <fstream>
#include <functional>
#include <future>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "acquisition/error.h"
#include "acquisition/exchange/csv.h"
#include "acquisition/exchange/hdf5.h"
#include "acquisition/exchange/mat.h"
#include "acquisition/exchange/new_file.h"
#include "acquisition/exchange/sha256.h"
#include "acquisition/recorder/output_file.h"
#include "acquisition/recording/mcap/import.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/recording/text_file.h"
#include "app/session/sync_report.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;
namespace exchange = acquisition::exchange;
using acquisition::Recording;

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

void write_as(const ExportOptions& options, const exchange::Contents& contents,
              const fs::path& file, const std::string& program) {
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

/// What lies beside an export: how its clocks were found, what it was made from, what it is.
nlohmann::json sidecar(const ExportOptions& options, const Recording& recording,
                       const Clocks& clocks, const fs::path& written, const fs::path& out,
                       nlohmann::json sources, const std::string& program) {
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

}  // namespace

Clocks clocks_of(const Recording& recording) {
  Clocks clocks{acquisition::synchronise(recording), {}};
  for (const auto& device : recording.devices)
    clocks.devices.push_back(acquisition::synchronise(recording, device));
  return clocks;
}

void export_recording(const Recording& recording, const Clocks& clocks,
                      const exchange::Contents& contents, const ExportOptions& options,
                      const fs::path& out, const std::string& program) {
  exchange::NewFile file(out, options.overwrite);
  exchange::NewFile report(out.string() + ".json", options.overwrite);
  auto sources = std::async(std::launch::async, sources_of, std::cref(recording));
  write_in_the_name_of(out, file.temporary(),
                       [&] { write_as(options, contents, file.temporary(), program); });
  const auto beside =
      sidecar(options, recording, clocks, file.temporary(), out, sources.get(), program);
  acquisition::write_text_file(
      report.temporary(),
      beside.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
  file.keep();
  report.keep();
}

}  // namespace searig::app
