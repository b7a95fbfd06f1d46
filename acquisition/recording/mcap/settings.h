// What holds for a whole recording and is no stream: written as JSON into its first message, and
// again where more became known; the last one counts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquisition/recording/recording.h"

namespace searig::acquisition::mcap {

/// Rows that were sorted and counted before they were written stand as they are when read.
struct SortedRows {
  StreamCounts counts;
  std::vector<std::size_t> restarts;
  double least_wire_s = 0.0;  ///< of pings, see Stream
};

struct StreamSettings {
  std::string source;  ///< "serial:/dev/ttyACM0", or the file that it was imported from
  std::string device;  ///< what the device says of itself, or empty
  unsigned baud = 0;   ///< of the line, or 0 where there is none
  std::optional<HostLatency> host_latency;
  std::optional<SortedRows> sorted;  ///< of an imported recording
};

/// A further device: which one, and how it is brought to the module's clock.
struct DeviceSettings {
  std::string name;  ///< "device.encoder"; its topic is "/device.encoder"
  AlignedBy aligned_by = AlignedBy::host;
  StreamSettings stream;
};

struct Settings {
  std::string program;  ///< who wrote it: "searig 0.1.0"
  std::string started;  ///< "2026-11-22T01:05:03Z", or empty where it is not known
  double gear_ratio = 1.0;
  double lever_arm_m = 1.0;
  bool one_clock = false;
  StreamSettings module, loadcell;
  std::vector<DeviceSettings> devices;
  std::string model_toml;
  std::string calibration;  ///< the load cell's, as calibration/ writes it, or empty
  std::string recorded;     ///< what was said of how it came to be: by an import, by the user
};

/// "host", "clock" or "velocity", and back; InputError as below where it is none of them.
const char* name_of(AlignedBy how);
AlignedBy aligned_by(std::string_view name);

std::string to_json(const Settings& settings);

/// Throws InputError with the rest of a sentence that begins with the file's name.
Settings settings_from_json(std::string_view json);

}  // namespace searig::acquisition::mcap
