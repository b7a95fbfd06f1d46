#include "acquisition/recording/mcap/import.h"

#include <algorithm>
#include <array>
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

/// A stream's columns, and the time that places its rows among those of the other streams.
struct Table {
  std::vector<std::string> names{"t_s"};
  std::vector<std::span<const double>> columns;
  std::span<const double> when;
  double shift_s = 0.0;  ///< of `when`, where the stream's clock is not that of the others
  std::uint16_t channel = 0;
  std::size_t next = 0;  ///< row to write

  Table(const Stream& stream, bool by_host) : columns{stream.t_s} {
    if (!stream.host_s.empty()) names.push_back("host_s"), columns.push_back(stream.host_s);
    for (const acquisition::Channel& one : stream.channels)
      names.push_back(one.name), columns.push_back(one.values);
    when = by_host ? stream.host_s : stream.t_s;
    for (std::size_t i = 0; i < columns.size(); ++i) check(stream, i);
  }

  bool ended() const { return next == when.size(); }
  double next_when() const { return when[next] + shift_s; }

  void check(const Stream& stream, std::size_t column) const {
    const std::string what = stream.name + "." + names[column];
    if (columns[column].size() != stream.t_s.size())
      throw std::invalid_argument(what + " has not as many values as there are rows.");
    for (const double value : columns[column])
      if (!std::isfinite(value)) throw std::invalid_argument(what + " is not finite everywhere.");
  }

  void next_row(std::vector<double>& values) {
    values.clear();
    for (const auto& column : columns) values.push_back(column[next]);
    ++next;
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
    to.sorted = {from.counts, from.restarts, from.least_wire_s};
  };
  stream(recording.module, settings.module);
  stream(recording.loadcell, settings.loadcell);
  for (const Device& device : recording.devices) {
    settings.devices.push_back({device.stream.name, device.aligned_by, {}});
    stream(device.stream, settings.devices.back().stream);
  }
  settings.calibration = recording.calibration;
  settings.recorded = recording.recorded;
  return settings;
}

/// Module, load cell, further devices. A device on a clock of its own begins with the module: that
/// places its messages in the file and says nothing of its clock.
std::vector<Table> tables_of(const Recording& recording) {
  const bool by_host = !recording.module.host_s.empty() && !recording.loadcell.host_s.empty();
  std::vector<Table> tables;
  tables.emplace_back(recording.module, by_host);
  tables.emplace_back(recording.loadcell, by_host);
  for (const Device& device : recording.devices) {
    const bool stamped = by_host && !device.stream.host_s.empty();
    tables.emplace_back(device.stream, stamped);
    const bool placed = stamped || (!by_host && device.aligned_by == AlignedBy::clock);
    if (!placed && !device.stream.t_s.empty())
      tables.back().shift_s = tables.front().when.front() - tables.back().when.front();
  }
  return tables;
}

/// All streams' rows, the earlier first, in chunks as long as those of a recorded file.
void write_rows(RecordingWriter& out, std::vector<Table>& tables) {
  double chunk_from = -HUGE_VAL;
  std::vector<double> row;
  while (true) {
    Table* first = nullptr;
    for (Table& table : tables)
      if (!table.ended() && (!first || table.next_when() < first->next_when())) first = &table;
    if (!first) return;
    const double when = first->next_when();
    if (std::abs(when - chunk_from) >= chunk_s) {
      out.file().end_chunk();
      chunk_from = when;
    }
    first->next_row(row);
    out.row(first->channel, when, row);
  }
}

void write_pings(RecordingWriter& out, StreamId device, const Stream& stream) {
  static const std::vector<std::string> names{"host_s", "host_sent_s", "device_received_s",
                                              "device_s", "run"};
  for (const Exchange& ping : stream.pings)
    out.ping(device, names,
             std::array{ping.host_received_s, ping.host_sent_s, ping.device_received_s,
                        ping.device_sent_s, double(ping.run)});
}

}  // namespace

void write_mcap(const Recording& recording, const std::vector<fs::path>& originals,
                const std::string& program, const Writer::Sink& sink) {
  std::vector<Table> tables = tables_of(recording);
  double first = 0.0;
  for (const Table& table : tables)
    for (const double when : table.when) first = std::min(first, when + table.shift_s);

  RecordingWriter out(sink, program, -first);  // MCAP knows no time below zero
  out.settings(settings_of(recording, program), first);
  out.set_columns(StreamId::module, tables[0].names);
  out.set_columns(StreamId::loadcell, tables[1].names);
  tables[0].channel = out.channel_of(StreamId::module);
  tables[1].channel = out.channel_of(StreamId::loadcell);
  for (std::size_t i = 2; i < tables.size(); ++i)
    tables[i].channel = out.add_device(recording.devices[i - 2].stream.name, tables[i].names);
  write_rows(out, tables);
  write_pings(out, StreamId::module, recording.module);
  write_pings(out, StreamId::loadcell, recording.loadcell);
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
  std::vector<fs::path> candidates{
      fs::is_directory(recording.path) ? folder / "recording.toml" : recording.path,
      folder / "model.toml", recording.module.file, recording.loadcell.file};
  for (const Device& device : recording.devices) candidates.push_back(device.stream.file);
  for (const fs::path& file : candidates) {
    std::error_code not_there;
    if (fs::is_regular_file(file, not_there) && seen.insert(fs::canonical(file)).second)
      files.push_back(file);
  }
  return files;
}

}  // namespace searig::acquisition::mcap
