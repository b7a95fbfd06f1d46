#include "acquisition/recording/recording.h"

#include <utility>

#include "acquisition/error.h"
#include "acquisition/recording/hebilog/read_hebilog.h"
#include "acquisition/recording/mapping.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/recording/module_rows.h"
#include "acquisition/recording/stream_reader.h"

namespace searig::acquisition {
namespace {

namespace fs = std::filesystem;

/// recording.toml of a recording; says what is wrong with the path where there is none.
fs::path toml_of(const fs::path& recording) {
  std::error_code error;
  const fs::file_status status = fs::status(recording, error);
  if (status.type() == fs::file_type::not_found)
    throw InputError(recording.string() + ": there is no such recording.");
  if (error) throw InputError(recording.string() + ": cannot be read: " + error.message() + ".");
  if (!fs::is_directory(status)) {
    if (recording.extension() == ".toml") return recording;
    throw InputError(recording.string() +
                     ": is no recording; an .mcap file or a folder with a recording.toml is one.");
  }
  const fs::path toml = recording / "recording.toml";
  if (!fs::exists(toml, error))
    throw InputError(error ? recording.string() + ": cannot be read: " + error.message() + "."
                           : toml.string() + ": is missing; it makes a folder a recording.");
  return toml;
}

/// The column a mapping takes as its clock; native files have theirs in t_s.
const ColumnMapping* clock_column(const StreamMapping& stream) {
  for (const ColumnMapping& column : stream.columns)
    if (column.channel == "t_s") return &column;
  return nullptr;
}

bool same_clock_column(const StreamMapping& a, const StreamMapping& b) {
  std::error_code error;
  if (!fs::equivalent(a.file, b.file, error) || error) return false;
  const ColumnMapping* one = clock_column(a);
  const ColumnMapping* other = clock_column(b);
  return one && other ? one->column == other->column : one == other;
}

/// Channels have one source each, and what aligns a device has to be there.
void check(const Device& device, const Recording& so_far, const fs::path& toml) {
  const auto refuse = [&](const std::string& what) {
    throw InputError(toml.string() + ": " + device.stream.name + " " + what + ".");
  };
  for (const Channel& channel : device.stream.channels) {
    if (channel.name == "seq") continue;
    if (channel.name == "force_n" || channel.name == "torque_nm")
      refuse("supplies " + channel.name + ", which only the load cell has");
    if (!so_far.module.channel(channel.name).empty())
      refuse("supplies " + channel.name + ", which the module already has");
    for (const Device& other : so_far.devices)
      if (!other.stream.channel(channel.name).empty())
        refuse("supplies " + channel.name + ", which " + other.stream.name + " already does");
  }
  if (device.aligned_by == AlignedBy::host &&
      (device.stream.host_s.empty() || so_far.module.host_s.empty()))
    refuse("cannot be aligned by host: it needs host_s in it and in the module, or aligned_by");
  if (device.aligned_by != AlignedBy::velocity) return;
  if (so_far.module.channel("input_velocity_rad_s").empty())
    refuse("cannot be aligned by velocity: the module has no input_velocity_rad_s");
  if (device.stream.channel("input_angle_rad").empty() &&
      device.stream.channel("motor_angle_rad").empty())
    refuse("cannot be aligned by velocity: it has no input_angle_rad and no motor_angle_rad");
}

/// A module's stream out of CSV, or out of its vendor's log, which may hold further channels.
Stream module_of(const StreamMapping& mapping, Recording& recording) {
  if (!hebilog::is_hebilog(mapping.file)) return read_stream(mapping);
  Recording log = hebilog::read_hebilog(mapping.file);
  log.module.host_latency = mapping.host_latency;
  recording.devices = std::move(log.devices);
  recording.events = std::move(log.events);
  recording.recorded = std::move(log.recorded);
  return std::move(log.module);
}

/// All but the module's rows and further devices.
Recording frame_of(const fs::path& folder, const fs::path& toml, const RecordingMapping& mapping) {
  Recording recording;
  recording.path = folder;
  recording.name = fs::absolute(toml).lexically_normal().parent_path().filename().string();
  recording.gear_ratio = mapping.gear_ratio;
  recording.lever_arm_m = mapping.lever_arm_m.value_or(1.0);
  return recording;
}

void refuse_without_lever(const Recording& recording, const RecordingMapping& mapping,
                          const fs::path& toml) {
  if (recording.loadcell.channel("torque_nm").empty() && !mapping.lever_arm_m)
    throw InputError(toml.string() +
                     ": loadcell.lever_arm_m is missing; column force_n needs it to be a torque.");
}

class CsvModuleRows : public ModuleRows {
 public:
  explicit CsvModuleRows(StreamPieces pieces) : pieces_(std::move(pieces)) {}
  void go_through(const std::vector<std::string>& channels, const Take& take) const override {
    pieces_.go_through(channels, take);
  }
  bool has(std::string_view channel) const override { return pieces_.has(channel); }

 private:
  StreamPieces pieces_;
};

/// Times and arrivals of all rows.
void read_times(const ModuleRows& rows, Stream& module) {
  rows.go_through({}, [&](const Stream& piece) {
    module.t_s.insert(module.t_s.end(), piece.t_s.begin(), piece.t_s.end());
    module.host_s.insert(module.host_s.end(), piece.host_s.begin(), piece.host_s.end());
  });
}

/// At most so many rows can a CSV file have that takes no less for a row than its first ones do:
/// room for them all, so that it need not be doubled on the way.
void reserve_times(const StreamMapping& mapping, Stream& module) {
  std::error_code unknown;
  constexpr std::size_t least_bytes = 30;  // two times with microseconds
  const std::size_t rows = fs::file_size(mapping.file, unknown) / least_bytes;
  if (!unknown) module.t_s.reserve(rows), module.host_s.reserve(rows);
}

}  // namespace

std::optional<OpenedRecording> open_recording(const fs::path& path) {
  if (mcap::is_mcap(path)) return mcap::open_mcap(path);
  const fs::path toml = toml_of(path);
  const RecordingMapping mapping = read_mapping(toml);
  if (hebilog::is_hebilog(mapping.module.file) || !mapping.devices.empty()) return std::nullopt;
  StreamPieces pieces(mapping.module);
  const bool module_stamped = pieces.has("host_s");
  OpenedRecording out{frame_of(path, toml, mapping),
                      std::make_unique<CsvModuleRows>(std::move(pieces))};
  Recording& recording = out.recording;
  recording.loadcell = read_stream(mapping.loadcell);
  refuse_without_lever(recording, mapping, toml);
  recording.module.name = mapping.module.name;
  recording.module.file = mapping.module.file;
  recording.module.host_latency = mapping.module.host_latency;
  recording.one_clock = same_clock_column(mapping.module, mapping.loadcell) || !module_stamped ||
                        recording.loadcell.host_s.empty();
  if (recording.one_clock) return out;
  reserve_times(mapping.module, recording.module);
  read_times(*out.rows, recording.module);
  return out;
}

const std::vector<double>& Stream::channel(std::string_view wanted) const {
  static const std::vector<double> none;
  for (const Channel& candidate : channels)
    if (candidate.name == wanted) return candidate.values;
  return none;
}

Recording read_recording(const fs::path& folder) {
  if (mcap::is_mcap(folder)) return mcap::read_mcap(folder);
  const fs::path toml = toml_of(folder);
  const RecordingMapping mapping = read_mapping(toml);

  Recording recording = frame_of(folder, toml, mapping);
  recording.module = module_of(mapping.module, recording);
  recording.loadcell = read_stream(mapping.loadcell);
  for (const DeviceMapping& mapped : mapping.devices) {
    const Device device{read_stream(mapped.stream), mapped.aligned_by};
    check(device, recording, toml);
    recording.devices.push_back(device);
  }
  refuse_without_lever(recording, mapping, toml);
  recording.one_clock = same_clock_column(mapping.module, mapping.loadcell) ||
                        recording.module.host_s.empty() || recording.loadcell.host_s.empty();
  return recording;
}

}  // namespace searig::acquisition
