// What goes from the acquisition thread to the file, in its order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "acquisition/recording/mcap/recording_writer.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition {

using mcap::StreamId;

struct RawPiece {
  StreamId device;
  double host_s;
  std::vector<std::uint8_t> bytes;
};

/// The names of a device's samples, once, before the first of them.
struct Columns {
  StreamId device;
  std::vector<std::string> names;  ///< t_s, host_s, seq, run, then channels
};

struct SampleRow {
  StreamId device;
  std::vector<double> values;  ///< as Columns has them

  double t_s() const { return values[0]; }
  double host_s() const { return values[1]; }
  double run() const { return values[3]; }
};

/// What happened to the frames until now; values as counter_names.
struct CountersRow {
  StreamId device;
  std::vector<double> values;
};

/// The four times of a two-way exchange; values as ping_names.
struct PingRow {
  StreamId device;
  std::vector<double> values;
};

inline const std::vector<std::string> counter_names{
    "host_s", "samples", "lost",     "doubled",  "out_of_order",    "garbled",  "restarts",
    "bytes",  "foreign", "repeated", "at_limit", "device_overruns", "unplugged"};
inline const std::vector<std::string> ping_names{"host_s", "host_sent_s", "device_received_s",
                                                 "device_s", "run"};

/// More became known of what holds for the whole recording.
struct NewSettings {
  double host_s;
  mcap::Settings settings;
};

using Entry = std::variant<RawPiece, Columns, SampleRow, CountersRow, PingRow, Event, NewSettings>;

void write_entry(const Entry& entry, mcap::RecordingWriter& out);

/// Whether the others are of no use without it. Bytes and samples are many, and each stands alone.
inline bool must_come(const Entry& entry) {
  return !std::holds_alternative<RawPiece>(entry) && !std::holds_alternative<SampleRow>(entry);
}

}  // namespace searig::acquisition
