#include "acquisition/recording/mcap/recording_writer.h"

#include <utility>

#include "acquisition/recording/mcap/cdr.h"
#include "acquisition/recording/mcap/layout.h"

namespace searig::acquisition::mcap {
namespace {

std::string topic_of(StreamId device, const char* suffix) {
  return std::string(device == StreamId::module ? module_topic : loadcell_topic) + suffix;
}

std::string schema_of(StreamId device, const char* what) {
  return std::string("searig/") + name_of(device) + what;
}

}  // namespace

const char* name_of(StreamId device) {
  return device == StreamId::module ? "module" : "loadcell";
}

RecordingWriter::RecordingWriter(Writer::Sink sink, const std::string& program, double epoch_s)
    : file_(std::move(sink), program), epoch_s_(epoch_s) {}

void RecordingWriter::settings(const Settings& settings, double host_s) {
  if (settings_ == 0)
    settings_ = file_.add_channel(settings_topic, "searig/Settings", settings_definition);
  CdrWriter message;
  message << std::string_view(to_json(settings));
  file_.add(settings_, nanoseconds(epoch_s_ + host_s), message.bytes());
}

void RecordingWriter::set_columns(StreamId device, const std::vector<std::string>& columns) {
  samples_[std::size_t(device)] =
      file_.add_channel(topic_of(device, ""), schema_of(device, "Sample"), row_definition(columns));
}

void RecordingWriter::sample(StreamId device, double host_s, std::span<const double> values) {
  const std::uint16_t channel = samples_[std::size_t(device)];
  if (channel != 0) row(channel, host_s, values);
}

std::uint16_t RecordingWriter::add_device(const std::string& name,
                                          const std::vector<std::string>& columns) {
  return file_.add_channel("/" + name, "searig/DeviceSample", row_definition(columns));
}

void RecordingWriter::raw(StreamId device, double host_s, std::string_view bytes) {
  std::uint16_t& channel = raw_[std::size_t(device)];
  if (channel == 0)
    channel =
        file_.add_channel(topic_of(device, raw_suffix), schema_of(device, "Raw"), raw_definition);
  CdrWriter message;
  message << host_s;
  message.raw(bytes);
  file_.add(channel, nanoseconds(epoch_s_ + host_s), message.bytes());
}

void RecordingWriter::counters(StreamId device, const std::vector<std::string>& names,
                               std::span<const double> values) {
  std::uint16_t& channel = counters_[std::size_t(device)];
  if (channel == 0)
    channel = file_.add_channel(topic_of(device, counters_suffix), schema_of(device, "Counters"),
                                row_definition(names));
  row(channel, values.front(), values);  // host_s comes first
}

void RecordingWriter::ping(StreamId device, const std::vector<std::string>& names,
                           std::span<const double> values) {
  std::uint16_t& channel = pings_[std::size_t(device)];
  if (channel == 0)
    channel = file_.add_channel(topic_of(device, pings_suffix), schema_of(device, "Ping"),
                                row_definition(names));
  row(channel, values.front(), values);
}

void RecordingWriter::clock(double host_s, const ClockMap& map) {
  if (clock_ == 0)
    clock_ = file_.add_channel(clock_topic, "searig/Clock",
                               row_definition({"host_s", "rate", "offset_s", "ci95_s", "trusted"}));
  row(clock_, host_s,
      std::array{host_s, map.rate, map.offset_s, map.ci95_s, map.trusted ? 1.0 : 0.0});
}

void RecordingWriter::event(const Event& event) {
  if (events_ == 0) events_ = file_.add_channel(events_topic, "searig/Event", event_definition);
  CdrWriter message;
  message << event.host_s << std::string_view(event.device) << std::string_view(event.kind)
          << std::string_view(event.text);
  file_.add(events_, nanoseconds(epoch_s_ + event.host_s), message.bytes());
}

void RecordingWriter::row(std::uint16_t channel, double host_s, std::span<const double> values) {
  CdrWriter message;
  for (const double value : values) message << value;
  file_.add(channel, nanoseconds(epoch_s_ + host_s), message.bytes());
}

}  // namespace searig::acquisition::mcap
