#include "acquisition/recording/hebilog/read_hebilog.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include "acquisition/error.h"
#include "acquisition/recording/hebilog/channels.h"
#include "acquisition/recording/hebilog/frames.h"
#include "acquisition/recording/hebilog/logs.h"
#include "acquisition/recording/hebilog/module_stream.h"
#include "acquisition/recording/mapped_file.h"

namespace searig::acquisition::hebilog {
namespace {

/// "Recorded 2018-07-05T20:06:00Z by a HEBI module (X5-1, X-00131, My Family/Test Module)."
std::string recorded_by(const Log& log) {
  const auto started = static_cast<std::time_t>(log.log_us.front() / 1000000);
  std::tm utc{};
  char date[32] = "";
  if (gmtime_r(&started, &utc)) std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc);
  const auto text = [&](Path path) {
    const auto found = log.texts.find(path);
    return found == log.texts.end() ? std::string("?") : found->second;
  };
  return std::string("Recorded ") + date + " by a HEBI module (" + text(mechanical_type) + ", " +
         text(serial_number) + ", " + text(family) + "/" + text(name) + ").";
}

/// A stream of those rows of the module that have the channel, if there is none of its kind with
/// the same rows yet.
Stream& partial_stream(Recording& recording, const std::vector<std::size_t>& rows, bool command) {
  const std::vector<double> t_s = at(rows, recording.module.t_s);
  const std::string kind = command ? "device.command" : "device.partial";
  for (Device& device : recording.devices)
    if (device.stream.name.starts_with(kind) && device.stream.t_s == t_s) return device.stream;
  std::string called = kind;
  for (int i = 2; std::ranges::any_of(recording.devices,
                                      [&](const Device& d) { return d.stream.name == called; });
       ++i)
    called = kind + "_" + std::to_string(i);
  Stream stream;
  stream.name = called;
  stream.t_s = t_s;
  stream.host_s = at(rows, recording.module.host_s);
  stream.counts.received = rows.size();
  for (const std::size_t restart : recording.module.restarts) {
    const auto first = std::size_t(std::ranges::lower_bound(rows, restart) - rows.begin());
    if (first > 0 && first < rows.size()) stream.restarts.push_back(first);
  }
  recording.devices.push_back({std::move(stream), AlignedBy::clock});
  return recording.devices.back().stream;
}

void add_channel(Recording& recording, const std::string& channel, std::vector<double> values,
                 bool command) {
  std::vector<std::size_t> rows;
  for (std::size_t row = 0; row < values.size(); ++row)
    if (std::isfinite(values[row])) rows.push_back(row);
  if (rows.empty()) return;
  if (rows.size() == values.size())
    recording.module.channels.push_back({channel, std::move(values)});
  else
    partial_stream(recording, rows, command).channels.push_back({channel, at(rows, values)});
}

/// The angle before the spring, which is not sent.
void add_input_angle(Stream& module) {
  const std::vector<double>& output = module.channel("output_angle_rad");
  const std::vector<double>& deflection_rad = module.channel("deflection_rad");
  if (output.empty() || deflection_rad.empty()) return;
  std::vector<double> input(output);
  for (std::size_t row = 0; row < input.size(); ++row) input[row] += deflection_rad[row];
  module.channels.push_back({"input_angle_rad", std::move(input)});
}

void tell(Recording& recording, const Damage& damage) {
  if (damage.places == 0) return;
  std::string text = std::to_string(damage.bytes) + " bytes in " + std::to_string(damage.places) +
                     " places of the log are damaged and left out, the first at byte " +
                     std::to_string(damage.first_at);
  text += damage.at_end ? "; the log ends within a frame." : ".";
  recording.events.push_back({recording.module.host_s.back(), "module", "garbled", text});
  recording.module.counts.garbled += damage.places;
}

}  // namespace

bool is_hebilog(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  char first[4] = {};
  std::ifstream(path, std::ios::binary).read(first, sizeof first);
  return std::string_view(first, 4) == std::string_view("\x73\xB1\0\x02", 4) ||
         path.extension() == ".hebilog";
}

Recording recording_of(std::string_view bytes, std::optional<std::size_t> module) {
  Logs logs = read_logs(bytes);
  Log& log = chosen(logs, module);
  Recording recording;
  recording.recorded = recorded_by(log);
  recording.loadcell.name = "loadcell";
  std::vector<std::size_t> order;
  recording.module = stream_of(log, order);
  add_pings(recording.module, log, order);
  for (const auto& [path, sent] : log.fields) {
    const auto channel = channel_of(path);
    if (!channel) continue;
    std::vector<double> values = at(order, log.field(path));
    if (path == deflection)
      for (double& value : values) value = -value;
    add_channel(recording, *channel, std::move(values), is_command(path));
  }
  add_input_angle(recording.module);
  tell(recording, logs.damage);
  return recording;
}

Recording read_hebilog(const std::filesystem::path& path, std::optional<std::size_t> module) {
  const MappedFile file(path);
  try {
    Recording recording = recording_of(file.bytes(), module);
    recording.path = path;
    recording.name = path.stem().string();
    recording.module.file = path;
    for (Device& device : recording.devices) device.stream.file = path;
    return recording;
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
}

}  // namespace searig::acquisition::hebilog
