// A recording as it came: two streams, each on its own clock, nothing mended.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace searig::acquisition {

/// One named channel, SI units with the unit in the name ("deflection_rad").
struct Channel {
  std::string name;
  std::vector<double> values;
};

/// What happened to the rows of a stream between the device and here.
struct StreamCounts {
  std::size_t received = 0;      ///< rows kept
  std::size_t lost = 0;          ///< gaps in seq, or in device time where there is no seq
  std::size_t doubled = 0;       ///< rows seen again (same seq or same device time)
  std::size_t garbled = 0;       ///< rows that could not be read or hold no finite time
  std::size_t out_of_order = 0;  ///< rows older than their predecessor
};

/// How long a row takes from device to host at the least, s, and how well that is known.
struct HostLatency {
  double latency_s = 0.0;
  double ci95_s = 0.0;
};

/// The four times of a two-way exchange, s, and the run of the device that they belong to.
struct Exchange {
  double host_sent_s = 0.0;
  double device_received_s = 0.0;
  double device_sent_s = 0.0;
  double host_received_s = 0.0;
  std::size_t run = 0;
};

/// One stream. t_s increases strictly within each run between restarts.
struct Stream {
  std::string name;                   ///< "module" or "loadcell"
  std::filesystem::path file;         ///< where it was read from
  std::vector<double> t_s;            ///< device clock, unwrapped
  std::vector<double> host_s;         ///< arrival at the host, or empty
  std::vector<Channel> channels;      ///< all of the size of t_s
  std::vector<std::size_t> restarts;  ///< rows at which the device clock began anew
  StreamCounts counts;

  /// The fixed part of the one-way latency from device to host, where recording.toml declares it
  /// (host_latency_s, host_latency_ci95_s). No arrival stamp can show it.
  std::optional<HostLatency> host_latency;

  std::vector<Exchange> pings;  ///< in order of arrival; runs as `restarts` divides them
  double least_wire_s = 0.0;    ///< what a ping, and as much a pong, is on the wire at the least

  /// The values of a channel, or an empty vector where the stream has no such channel.
  const std::vector<double>& channel(std::string_view name) const;
};

/// What a further device's clock is brought to the module's by.
enum class AlignedBy {
  host,      ///< arrival stamps in both
  clock,     ///< nothing: it is the module's clock
  velocity,  ///< its angle's derivative, held against the module's input_velocity_rad_s
};

/// A further device, on a clock of its own, that supplies channels which the module lacks.
struct Device {
  Stream stream;  ///< named "device.<its name>"
  AlignedBy aligned_by = AlignedBy::host;
};

/// Something that befell a device or the recording itself while it ran.
struct Event {
  double host_s = 0.0;
  std::string device;  ///< "module", "loadcell", or empty
  std::string kind;    ///< "unplugged", "reconnected", "restart", "garbled" ...
  std::string text;    ///< one sentence for people
  bool operator==(const Event&) const = default;
};

struct Recording {
  std::string name;  ///< folder or file name without its path
  std::filesystem::path path;
  Stream module;
  Stream loadcell;
  std::vector<Device> devices;
  double gear_ratio = 1.0;
  double lever_arm_m = 1.0;
  bool one_clock = false;  ///< both streams already share a clock

  // What only a recording in one file (.mcap) has.
  std::string recorded;  ///< by which program, when and from which devices
  std::vector<Event> events;
  std::string model_toml;   ///< the simulation that its owner believes in, or empty
  std::string calibration;  ///< the load cell's, as calibration/ writes it, or empty
  std::string cut_off;     ///< one sentence where the file ends before its end, or empty
};

/// Reads a recording: an .mcap file (recording/mcap/), a folder, or the recording.toml in it (see
/// the contract and, for mappings of other CSV files, recording/mapping.h). Damaged rows are
/// counted; what is damage and what is an unusable file says recording/csv.h for the rows and
/// recording/stream_reader.h for the clock. Throws InputError: one sentence with file, line and
/// column.
Recording read_recording(const std::filesystem::path& folder);

}  // namespace searig::acquisition
