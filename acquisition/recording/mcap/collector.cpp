#include "acquisition/recording/mcap/collector.h"

#include <utility>

#include "acquisition/clock/ping_clock.h"
#include "acquisition/recording/mcap/cdr.h"
#include "acquisition/recording/mcap/layout.h"
#include "acquisition/recording/mcap/read_mcap.h"

namespace searig::acquisition::mcap {
namespace {

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

void Collector::channel(const Channel& channel, const Schema& schema) {
  if (channel.encoding != "cdr" || schema.encoding != "ros2msg") return;
  if (channel.topic == settings_topic) settings_channel_ = channel.id;
  if (channel.topic == events_topic) events_channel_ = channel.id;
  rows_of(channel, schema, module_topic, module);
  rows_of(channel, schema, loadcell_topic, loadcell);
  if (channel.topic.starts_with(device_topics)) rows_of(channel, schema, devices[channel.topic]);
}

void Collector::message(const Message& message) {
  if (const auto rows = rows_.find(message.channel); rows != rows_.end()) {
    rows->second->take(message.data);
  } else if (message.channel == settings_channel_) {
    settings = settings_from_json(CdrReader(message.data).text());
  } else if (message.channel == events_channel_) {
    take_event(message.data);
  }
}

void Collector::rows_of(const Channel& channel, const Schema& schema, const std::string& topic,
                        ReceivedRows& received) {
  if (channel.topic == topic && (&received != &module || module_samples_))
    rows_of(channel, schema, received.samples);
  if (channel.topic == topic + counters_suffix) rows_of(channel, schema, received.counters);
  if (channel.topic == topic + pings_suffix) rows_of(channel, schema, received.pings);
}

void Collector::rows_of(const Channel& channel, const Schema& schema, Rows& rows) {
  rows.names = row_columns(schema.text);
  rows.columns.assign(rows.names.size(), {});
  if (!rows.names.empty()) rows_[channel.id] = &rows;
}

void Collector::take_event(std::string_view data) {
  CdrReader reader(data);
  Event event;
  event.host_s = reader.number<double>();
  event.device = reader.text();
  event.kind = reader.text();
  event.text = reader.text();
  if (reader.fits()) events.push_back(std::move(event));
}

Recording assembled(Collector& found, const Ending& ending, std::size_t size) {
  const Settings& settings = *found.settings;
  Recording recording;
  recording.gear_ratio = settings.gear_ratio;
  recording.lever_arm_m = settings.lever_arm_m;
  recording.one_clock = settings.one_clock;
  recording.model_toml = settings.model_toml;
  recording.calibration = settings.calibration;
  recording.recorded = recorded_by(settings);
  recording.events = std::move(found.events);
  recording.cut_off = cut_off(ending, size);
  recording.module = stream_of("module", found.module, settings.module);
  recording.loadcell = stream_of("loadcell", found.loadcell, settings.loadcell);
  if (!settings.loadcell.sorted)
    recording.loadcell.least_wire_s = least_ping_wire_s(settings.loadcell.baud);
  for (const DeviceSettings& device : settings.devices)
    recording.devices.push_back(
        {stream_of(device.name, {found.devices["/" + device.name], {}, {}}, device.stream),
         device.aligned_by});
  return recording;
}

void name_after(const std::filesystem::path& path, Recording& recording) {
  recording.path = path;
  recording.name = path.stem().string();
  recording.module.file = recording.loadcell.file = path;
  for (Device& device : recording.devices) device.stream.file = path;
}

}  // namespace searig::acquisition::mcap
