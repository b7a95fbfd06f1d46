// recording.toml: which columns of which files are the channels, in which units.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "acquisition/recording/csv.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// Where a channel comes from: channel = scale * to_si(column).
struct ColumnMapping {
  std::string channel;                            ///< "deflection_rad"
  std::variant<std::string, std::size_t> column;  ///< its name, or its number from 0
  double scale = 1.0;                             ///< after the unit's own factor
  double offset = 0.0;                            ///< of the unit (K, degF)
  std::optional<double> wraps_at;                 ///< an unsigned counter that should be signed
};

/// How one stream is to be read.
struct StreamMapping {
  std::string name;
  std::filesystem::path file;
  bool native = true;                  ///< columns are named as the channels are
  Faults faults = Faults::refuse;      ///< count where mapped, unless recording.toml says otherwise
  std::vector<ColumnMapping> columns;  ///< empty where native
  std::optional<HostLatency> host_latency;
};

struct DeviceMapping {
  StreamMapping stream;
  AlignedBy aligned_by = AlignedBy::host;
};

struct RecordingMapping {
  StreamMapping module;
  StreamMapping loadcell;
  std::vector<DeviceMapping> devices;
  double gear_ratio = 1.0;
  std::optional<double> lever_arm_m;
};

/// The channel without which the stream is of no use, in words; empty where it has all it needs. A
/// stream without a clock is no stream; half a pair of angles is a mistake; a load cell without a
/// reading says nothing. All else may be missing and switches off what needs it.
std::string missing_channel(const StreamMapping& stream, const std::vector<ColumnMapping>& columns);

/// Reads recording.toml. Each of [module] and [loadcell] has `file`; beside the contract's keys:
///
///     [loadcell]
///     faults = "count"            # or "refuse", see Faults (native refuses, mapped counts)
///     host_latency_s = 0.0021     # fixed part of the one-way latency, where it is known,
///     host_latency_ci95_s = 3e-4  # and how well
///     [loadcell.columns]
///     t_s = { column = 0, unit = "ms" }                   # a number: the file has no header
///     current_a = { column = "I", unit = "mA", wraps_at = 65536 }  # 65533 is -3
///
/// A further device supplies channels that the module lacks; there may be several:
///
///     [device.encoder]
///     file = "encoder.csv"
///     aligned_by = "velocity"     # or "host" (the default), or "clock"; see AlignedBy
///     [device.encoder.columns]
///     t_s = { column = 0 }
///     input_angle_rad = { column = 1, scale = 0.02 }
///
/// Throws InputError that names the file, the line and the key.
RecordingMapping read_mapping(const std::filesystem::path& toml_file);

}  // namespace searig::acquisition
