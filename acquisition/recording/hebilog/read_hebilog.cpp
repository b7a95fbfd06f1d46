#include "acquisition/recording/hebilog/read_hebilog.h"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <fstream>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "acquisition/clock/device_clock.h"
#include "acquisition/error.h"
#include "acquisition/recording/hebilog/channels.h"
#include "acquisition/recording/hebilog/frames.h"
#include "acquisition/recording/mapped_file.h"

namespace searig::acquisition::hebilog {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// The feedback of one module, field by field.
struct Log {
  std::vector<std::uint64_t> log_us;
  std::map<Path, std::vector<double>> fields;  ///< of the size of log_us; NaN where not sent
  std::map<Path, std::string> texts;           ///< from information: what the module is

  void set(Path path, double value) {
    std::vector<double>& values = fields[path];
    values.resize(log_us.size(), missing);
    values.back() = value;
  }

  const std::vector<double>& field(Path path) {
    std::vector<double>& values = fields[path];
    values.resize(log_us.size(), missing);
    return values;
  }
};

bool take_feedback(Log& log, const Frame& frame) {
  std::vector<std::pair<Path, double>> row;
  const bool whole = read_message(
      frame.message,
      {is_message,
       [&](Path path, std::uint64_t v) {
         row.emplace_back(path, double(std::int64_t(v)));  // negative ones are 64 bits long
       },
       [&](Path path, double v) { row.emplace_back(path, v); }, [](Path, std::string_view) {}});
  const auto has = [&](Path path) {
    return std::ranges::find(row, path, &std::pair<Path, double>::first) != row.end();
  };
  if (!whole || !has(hardware_sent_us)) return false;
  log.log_us.push_back(frame.log_us);
  for (const auto& [path, value] : row) log.set(path, value);
  return true;
}

bool take_information(Log& log, const Frame& frame) {
  return read_message(frame.message, {is_message, [](Path, std::uint64_t) {}, [](Path, double) {},
                                      [&](Path path, std::string_view text) {
                                        log.texts[path] = std::string(text);
                                      }});
}

struct Logs {
  std::map<std::uint64_t, Log> by_address;
  Damage damage;
};

Logs read_logs(std::string_view bytes) {
  Logs logs;
  logs.damage = read_frames(bytes, [&](const Frame& frame) {
    if (frame.type == Frame::Type::feedback)
      return take_feedback(logs.by_address[frame.address], frame);
    if (frame.type == Frame::Type::information)
      return take_information(logs.by_address[frame.address], frame);
    return true;
  });
  std::erase_if(logs.by_address, [](const auto& log) { return log.second.log_us.size() < 2; });
  return logs;
}

Log& chosen(Logs& logs, std::optional<std::size_t> module) {
  const std::size_t all = logs.by_address.size();
  if (all == 0) throw InputError("holds no feedback of a HEBI module.");
  if (module.value_or(1) < 1 || module.value_or(1) > all)
    throw InputError("holds the logs of " + std::to_string(all) + " modules; there is no module " +
                     std::to_string(*module) + ".");
  if (!module && all > 1)
    throw InputError("holds the logs of " + std::to_string(all) +
                     " modules, and a recording is of one; --module 1 to " + std::to_string(all) +
                     " says which.");
  return std::next(logs.by_address.begin(), std::ptrdiff_t(module.value_or(1) - 1))->second;
}

std::vector<double> seconds(const std::vector<double>& us) {
  std::vector<double> values;
  for (const double value : us) values.push_back(value / 1e6);
  return values;
}

std::vector<double> at(const std::vector<std::size_t>& rows, const std::vector<double>& values) {
  std::vector<double> picked;
  for (const std::size_t row : rows) picked.push_back(values[row]);
  return picked;
}

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

/// The rows in order of the module's clock, everything else counted; all else goes by `order`.
Stream stream_of(Log& log, std::vector<std::size_t>& order) {
  const std::vector<double> t_s = seconds(log.field(hardware_sent_us));
  std::vector<double> host_s;
  for (const std::uint64_t us : log.log_us) host_s.push_back(double(us) / 1e6);
  std::vector<double> seq = log.field(sequence);
  const bool counted = std::ranges::none_of(seq, [](double v) { return std::isnan(v); });
  if (!counted) seq.clear();
  ClockedRows rows = read_device_clock(t_s, host_s, seq);

  Stream stream;
  stream.name = "module";
  stream.t_s = std::move(rows.t_s);
  stream.host_s = at(rows.order, host_s);
  if (counted) stream.channels.push_back({"seq", at(rows.order, seq)});
  stream.restarts = std::move(rows.restarts);
  stream.counts = {rows.order.size(), rows.lost, rows.doubled, rows.astray, rows.out_of_order};
  order = std::move(rows.order);
  return stream;
}

void add_pings(Stream& stream, Log& log, const std::vector<std::size_t>& order) {
  const std::vector<double> sent = at(order, seconds(log.field(host_sent_us)));
  const std::vector<double> received = at(order, seconds(log.field(hardware_received_us)));
  std::size_t run = 0;
  for (std::size_t row = 0; row < order.size(); ++row) {
    if (run < stream.restarts.size() && row == stream.restarts[run]) ++run;
    if (!std::isnan(sent[row]) && !std::isnan(received[row]))
      stream.pings.push_back({sent[row], received[row], stream.t_s[row], stream.host_s[row], run});
  }
}

/// A stream of those rows of the module that have the channel, if there is none of the same rows
/// yet.
Stream& partial_stream(Recording& recording, const std::vector<std::size_t>& rows, bool command) {
  const std::vector<double> t_s = at(rows, recording.module.t_s);
  for (Device& device : recording.devices)
    if (device.stream.t_s == t_s) return device.stream;
  std::string called = command ? "device.command" : "device.partial";
  for (int i = 2; std::ranges::any_of(recording.devices,
                                      [&](const Device& d) { return d.stream.name == called; });
       ++i)
    called = (command ? "device.command_" : "device.partial_") + std::to_string(i);
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
