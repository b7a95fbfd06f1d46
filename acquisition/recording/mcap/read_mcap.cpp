#include "acquisition/recording/mcap/read_mcap.h"

#include <fstream>

#include "acquisition/clock/ping_clock.h"
#include "acquisition/error.h"
#include "acquisition/recording/mapped_file.h"
#include "acquisition/recording/mcap/cdr.h"
#include "acquisition/recording/mcap/layout.h"
#include "acquisition/recording/mcap/rows.h"

namespace searig::acquisition::mcap {
namespace {

/// Sorts messages into what they are for; topics that are not known are for other programs.
class Collector : public Handler {
 public:
  std::optional<Settings> settings;
  std::vector<Event> events;
  ReceivedRows module, loadcell;
  std::map<std::string, Rows> devices;  ///< by topic

  void channel(const Channel& channel, const Schema& schema) override {
    if (channel.encoding != "cdr" || schema.encoding != "ros2msg") return;
    if (channel.topic == settings_topic) settings_channel_ = channel.id;
    if (channel.topic == events_topic) events_channel_ = channel.id;
    rows_of(channel, schema, module_topic, module);
    rows_of(channel, schema, loadcell_topic, loadcell);
    if (channel.topic.starts_with(device_topics)) rows_of(channel, schema, devices[channel.topic]);
  }

  void message(const Message& message) override {
    if (const auto rows = rows_.find(message.channel); rows != rows_.end()) {
      rows->second->take(message.data);
    } else if (message.channel == settings_channel_) {
      settings = settings_from_json(CdrReader(message.data).text());
    } else if (message.channel == events_channel_) {
      take_event(message.data);
    }
  }

 private:
  void rows_of(const Channel& channel, const Schema& schema, const std::string& topic,
               ReceivedRows& received) {
    if (channel.topic == topic) rows_of(channel, schema, received.samples);
    if (channel.topic == topic + counters_suffix) rows_of(channel, schema, received.counters);
    if (channel.topic == topic + pings_suffix) rows_of(channel, schema, received.pings);
  }

  void rows_of(const Channel& channel, const Schema& schema, Rows& rows) {
    rows.names = row_columns(schema.text);
    rows.columns.assign(rows.names.size(), {});
    if (!rows.names.empty()) rows_[channel.id] = &rows;
  }

  void take_event(std::string_view data) {
    CdrReader reader(data);
    Event event;
    event.host_s = reader.number<double>();
    event.device = reader.text();
    event.kind = reader.text();
    event.text = reader.text();
    if (reader.fits()) events.push_back(std::move(event));
  }

  std::map<std::uint16_t, Rows*> rows_;
  int settings_channel_ = -1, events_channel_ = -1;
};

/// The last settings, nothing else.
class SettingsCollector : public Handler {
 public:
  std::optional<Settings> settings;

  void channel(const Channel& channel, const Schema&) override {
    if (channel.topic == settings_topic) channel_ = channel.id;
  }
  void message(const Message& message) override {
    if (message.channel == channel_) settings = settings_from_json(CdrReader(message.data).text());
  }

 private:
  int channel_ = -1;
};

/// "Recorded 2026-11-22T01:05:03Z by searig 0.1.0 from sim: and sim:.", and how the load cell was
/// calibrated: its first line says that in words, behind a #.
std::string recorded_by(const Settings& settings) {
  if (!settings.recorded.empty() || settings.started.empty()) return settings.recorded;
  const auto source = [](const StreamSettings& stream) {
    std::string words = stream.source;
    if (!stream.device.empty()) words.append(" (").append(stream.device).append(")");
    return words;
  };
  std::string words = "Recorded " + settings.started + " by " + settings.program + " from ";
  words.append(source(settings.module)).append(" and ").append(source(settings.loadcell) + ".");
  if (const std::string& toml = settings.calibration; toml.starts_with("# "))
    words.append("\n").append(toml, 2, toml.find('\n') - 2);
  return words;
}

}  // namespace

bool is_mcap(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return false;
  if (path.extension() == ".mcap") return true;
  std::string first(magic.size(), '\0');
  std::ifstream(path, std::ios::binary).read(first.data(), std::streamsize(first.size()));
  return first == magic;
}

std::string cut_off(const Ending& ending, std::size_t size) {
  if (ending.end == End::whole) return {};
  const std::string sentence = "The file " + ending.why;
  if (ending.end == End::index) return sentence + "; all its data are there.";
  const std::size_t left_out = size - ending.valid_bytes;
  if (left_out == 0) return sentence + "; everything up to its end is there.";
  return sentence + "; " + std::to_string(left_out) + " bytes behind what is whole are left out.";
}

Recording recording_of(std::string_view bytes, const std::string& name) {
  Collector found;
  Ending ending;
  try {
    ending = read(bytes, found);
  } catch (const InputError& error) {
    throw InputError(name + ": " + error.what());
  }
  if (ending.end == End::unfit) throw InputError(name + ": " + ending.why + ".");
  if (!found.settings)
    throw InputError(name + ": " +
                     (ending.all_data() ? "is an MCAP file, but no recording of searig's."
                                        : ending.why + "; nothing before that can be read."));
  const Settings& settings = *found.settings;

  Recording recording;
  recording.gear_ratio = settings.gear_ratio;
  recording.lever_arm_m = settings.lever_arm_m;
  recording.one_clock = settings.one_clock;
  recording.model_toml = settings.model_toml;
  recording.calibration = settings.calibration;
  recording.recorded = recorded_by(settings);
  recording.events = std::move(found.events);
  recording.cut_off = cut_off(ending, bytes.size());
  recording.module = stream_of("module", found.module, settings.module);
  recording.loadcell = stream_of("loadcell", found.loadcell, settings.loadcell);
  if (!settings.loadcell.sorted)
    recording.loadcell.least_wire_s = least_ping_wire_s(settings.loadcell.baud);
  for (const DeviceSettings& device : settings.devices)
    recording.devices.push_back(
        {stream_of(device.name, {found.devices["/" + device.name], {}, {}}, device.stream),
         device.aligned_by});
  const auto& loadcell = settings.loadcell.sorted;
  refuse_unusable(recording, loadcell && loadcell->counts.received == 0, name);
  return recording;
}

Recording read_mcap(const std::filesystem::path& path) {
  const MappedFile file(path);
  Recording recording = recording_of(file.bytes(), path.string());
  recording.path = path;
  recording.name = path.stem().string();
  recording.module.file = recording.loadcell.file = path;
  for (Device& device : recording.devices) device.stream.file = path;
  return recording;
}

Settings read_settings(const std::filesystem::path& path) {
  const MappedFile file(path);
  SettingsCollector found;
  try {
    read(file.bytes(), found);
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
  if (!found.settings) throw InputError(path.string() + ": is no recording of searig's.");
  return *found.settings;
}

}  // namespace searig::acquisition::mcap
