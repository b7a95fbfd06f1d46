#include "acquisition/recording/mcap/import.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <span>
#include <stdexcept>

#include "acquisition/recording/mcap/recording_writer.h"
#include "acquisition/recording/text_file.h"

namespace searig::acquisition::mcap {
namespace {

namespace fs = std::filesystem;

constexpr double chunk_s = 0.25;  // of the recording's own time, as in a recorded file

/// A stream's columns, and the time that places its rows among those of the other stream.
struct Table {
  std::vector<std::string> names{"t_s"};
  std::vector<std::span<const double>> columns;
  std::span<const double> when;

  Table(const Stream& stream, bool by_host) : columns{stream.t_s} {
    if (!stream.host_s.empty()) names.push_back("host_s"), columns.push_back(stream.host_s);
    for (const acquisition::Channel& channel : stream.channels)
      names.push_back(channel.name), columns.push_back(channel.values);
    when = by_host ? stream.host_s : stream.t_s;
    for (std::size_t i = 0; i < columns.size(); ++i) check(stream, i);
  }

  void check(const Stream& stream, std::size_t column) const {
    const std::string what = stream.name + "." + names[column];
    if (columns[column].size() != stream.t_s.size())
      throw std::invalid_argument(what + " has not as many values as there are rows.");
    for (const double value : columns[column])
      if (!std::isfinite(value)) throw std::invalid_argument(what + " is not finite everywhere.");
  }

  std::vector<double> row(std::size_t number) const {
    std::vector<double> values;
    for (const auto& column : columns) values.push_back(column[number]);
    return values;
  }
};

Settings settings_of(const Recording& recording, const std::string& program) {
  Settings settings;
  settings.program = program;
  settings.gear_ratio = recording.gear_ratio;
  settings.lever_arm_m = recording.lever_arm_m;
  settings.one_clock = recording.one_clock;
  settings.model_toml = recording.model_toml;
  const auto stream = [](const Stream& from, StreamSettings& to) {
    to.source = from.file.string();
    to.host_latency = from.host_latency;
    to.sorted = {from.counts, from.restarts};
  };
  stream(recording.module, settings.module);
  stream(recording.loadcell, settings.loadcell);
  return settings;
}

/// Both streams' rows, the earlier first, in chunks as long as those of a recorded file.
void write_rows(RecordingWriter& out, const Table& module, const Table& loadcell) {
  double chunk_from = -HUGE_VAL;
  std::size_t m = 0, l = 0;
  while (m < module.when.size() || l < loadcell.when.size()) {
    const bool take_module =
        l == loadcell.when.size() || (m < module.when.size() && module.when[m] <= loadcell.when[l]);
    const Table& table = take_module ? module : loadcell;
    const std::size_t row = take_module ? m++ : l++;
    if (std::abs(table.when[row] - chunk_from) >= chunk_s) {
      out.file().end_chunk();
      chunk_from = table.when[row];
    }
    out.sample(take_module ? StreamId::module : StreamId::loadcell, table.when[row],
               table.row(row));
  }
}

}  // namespace

void write_mcap(const Recording& recording, const std::vector<fs::path>& originals,
                const std::string& program, const Writer::Sink& sink) {
  const bool by_host = !recording.module.host_s.empty() && !recording.loadcell.host_s.empty();
  const Table module(recording.module, by_host), loadcell(recording.loadcell, by_host);
  double first = 0.0;
  for (const Table* table : {&module, &loadcell})
    for (const double when : table->when) first = std::min(first, when);

  RecordingWriter out(sink, program, -first);  // MCAP knows no time below zero
  out.settings(settings_of(recording, program), first);
  out.set_columns(StreamId::module, module.names);
  out.set_columns(StreamId::loadcell, loadcell.names);
  write_rows(out, module, loadcell);
  for (const Event& event : recording.events) out.event(event);
  for (const fs::path& file : originals) {
    const std::string text = read_text_file(file);
    out.file().attach({0, 0, file.filename().string(),
                       file.extension() == ".csv" ? "text/csv" : "text/plain", text});
  }
  out.file().add_metadata("searig", {{"program", program}});
  out.file().finish();
}

std::vector<fs::path> originals_of(const Recording& recording) {
  const fs::path folder =
      fs::is_directory(recording.path) ? recording.path : recording.path.parent_path();
  std::vector<fs::path> files;
  std::set<fs::path> seen;
  for (const fs::path& file :
       {fs::is_directory(recording.path) ? folder / "recording.toml" : recording.path,
        folder / "model.toml", recording.module.file, recording.loadcell.file}) {
    std::error_code not_there;
    if (fs::is_regular_file(file, not_there) && seen.insert(fs::canonical(file)).second)
      files.push_back(file);
  }
  return files;
}

}  // namespace searig::acquisition::mcap
