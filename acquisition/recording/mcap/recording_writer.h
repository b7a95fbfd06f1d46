// A recording into an MCAP file, message by message: what the recorder and the import share.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/mcap/settings.h"
#include "acquisition/recording/mcap/writer.h"

namespace searig::acquisition::mcap {

enum class StreamId : std::uint8_t { module = 0, loadcell = 1 };
const char* name_of(StreamId device);

class RecordingWriter {
 public:
  /// epoch_s: Unix time at which host_s was 0, so that other programs show the hour; the log time
  /// of a message is epoch_s + host_s.
  RecordingWriter(Writer::Sink sink, const std::string& program, double epoch_s);

  void settings(const Settings& settings, double host_s);

  /// Once for each device, before its first sample; what comes before is left out.
  void set_columns(StreamId device, const std::vector<std::string>& columns);
  void sample(StreamId device, double host_s, std::span<const double> row);

  /// A further device's samples; row() takes them by the channel that this gives.
  std::uint16_t add_device(const std::string& name, const std::vector<std::string>& columns);
  std::uint16_t channel_of(StreamId device) const { return samples_[std::size_t(device)]; }
  void row(std::uint16_t channel, double host_s, std::span<const double> values);

  void raw(StreamId device, double host_s, std::string_view bytes);
  void counters(StreamId device, const std::vector<std::string>& names,
                std::span<const double> row);
  void ping(StreamId device, const std::vector<std::string>& names, std::span<const double> row);
  void clock(double host_s, const ClockMap& map);
  void event(const Event& event);

  Writer& file() { return file_; }

 private:
  Writer file_;
  double epoch_s_;
  std::uint16_t settings_ = 0, events_ = 0, clock_ = 0;  // channels; 0 until they are needed
  std::array<std::uint16_t, 2> samples_{}, raw_{}, counters_{}, pings_{};  // by device
};

}  // namespace searig::acquisition::mcap
