#include "acquisition/recording/mcap/read_mcap.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <utility>

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

  /// The module's samples may be left out.
  explicit Collector(bool module_samples = true) : module_samples_(module_samples) {}

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
    if (channel.topic == topic && (&received != &module || module_samples_))
      rows_of(channel, schema, received.samples);
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

  bool module_samples_;
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

namespace {

/// All that was found, but module and load cell may be without samples.
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

}  // namespace

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
  Recording recording = assembled(found, ending, bytes.size());
  const auto& loadcell = found.settings->loadcell.sorted;
  refuse_unusable(recording, loadcell && loadcell->counts.received == 0, name);
  return recording;
}

Recording read_mcap(const std::filesystem::path& path) {
  const MappedFile file(path);
  Recording recording = recording_of(file.bytes(), path.string());
  name_after(path, recording);
  return recording;
}

namespace {

/// The module's samples in pieces; see ModuleRows. Gives the file's memory back as it goes.
class Pieces : public Handler {
 public:
  Pieces(const MappedFile& file, std::vector<std::string> channels, ModuleRows::Take take)
      : file_(file), wanted_(std::move(channels)), take_(std::move(take)) {}

  double run() const { return run_; }
  const std::vector<std::string>& names() const { return rows_.names; }

  void channel(const Channel& channel, const Schema& schema) override {
    if (channel.topic != module_topic || channel.encoding != "cdr" || schema.encoding != "ros2msg")
      return;
    if (channel_ >= 0) throw NotInOrder();  // two of them
    rows_.names = row_columns(schema.text);
    columns_.clear();
    if (rows_.names.empty()) return;
    channel_ = channel.id;
    piece_ = {};
    for (const std::string& name : rows_.names)
      if (std::ranges::find(wanted_, name) != wanted_.end()) piece_.channels.push_back({name, {}});
    auto next = piece_.channels.begin();
    for (const std::string& name : rows_.names)
      columns_.push_back(name == "t_s"                                         ? &piece_.t_s
                         : name == "host_s"                                    ? &piece_.host_s
                         : name == "run"                                       ? &runs_
                         : next != piece_.channels.end() && next->name == name ? &(next++)->values
                                                                               : nullptr);
  }

  void message(const Message& message) override {
    if (message.channel != channel_ || !rows_.parse(message.data, row_)) return;
    for (std::size_t i = 0; i < row_.size(); ++i)
      if (columns_[i]) columns_[i]->push_back(row_[i]);
  }

  void chunk_ended() override {
    if (piece_.t_s.size() >= few) hand_on();
  }
  void passed(std::uint64_t bytes) override { file_.forget(bytes); }

  /// What has not been handed on yet.
  void hand_on() {
    for (const double t : piece_.t_s) {
      if (!(t > last_s_)) throw NotInOrder();
      last_s_ = t;
    }
    for (const double run : runs_) {
      if (started_ && run != run_) throw NotInOrder();
      run_ = run, started_ = true;
    }
    if (!piece_.t_s.empty()) take_(piece_);
    piece_.t_s.clear(), piece_.host_s.clear(), runs_.clear();
    for (auto& one : piece_.channels) one.values.clear();
  }

 private:
  static constexpr std::size_t few = 4096;  // rows

  const MappedFile& file_;
  std::vector<std::string> wanted_;
  ModuleRows::Take take_;
  int channel_ = -1;
  Rows rows_;
  std::vector<double> row_, runs_;
  Stream piece_;
  std::vector<std::vector<double>*> columns_;  // where each number goes
  double last_s_ = -HUGE_VAL, run_ = 0.0;
  bool started_ = false;
};

class McapModuleRows : public ModuleRows {
 public:
  /// Of a file that was read as a whole up to `bytes`; `names` are the columns of its samples.
  McapModuleRows(std::filesystem::path path, std::uint64_t bytes, std::vector<std::string> names)
      : path_(std::move(path)), bytes_(bytes), names_(std::move(names)) {}

  void go_through(const std::vector<std::string>& channels, const Take& take) const override {
    const MappedFile file(path_);
    Pieces pieces(file, channels, take);
    read_again(file.bytes().substr(0, bytes_), pieces);
    pieces.hand_on();
  }
  bool has(std::string_view channel) const override {
    return std::ranges::find(names_, channel) != names_.end();
  }

 private:
  std::filesystem::path path_;
  std::uint64_t bytes_;
  std::vector<std::string> names_;
};

/// Everything but the module's channels.
class Facts : public Handler {
 public:
  Collector found{false};
  Stream times;
  Pieces pieces;

  explicit Facts(const MappedFile& file)
      : pieces(file, {}, [this](const Stream& piece) { take(piece); }), file_(file) {}

  bool two_clocks() const { return found.settings && !found.settings->one_clock; }

  void channel(const Channel& channel, const Schema& schema) override {
    found.channel(channel, schema), pieces.channel(channel, schema);
  }
  void message(const Message& message) override {
    last_ = message.data.data();
    found.message(message), pieces.message(message);
  }
  void chunk_ended() override { pieces.chunk_ended(); }
  void passed(std::uint64_t bytes) override { pieces.passed(bytes); }

 private:
  /// On one clock the first time and the last are enough.
  void take(const Stream& piece) {
    const bool both = two_clocks() && !piece.host_s.empty();
    if (times.t_s.empty() && both) {  // so that it need not be doubled on the way
      const double share = double(last_ - file_.bytes().data()) / double(file_.bytes().size());
      const auto rows = std::size_t(1.2 * double(piece.t_s.size()) / share);
      times.t_s.reserve(rows), times.host_s.reserve(rows);
    }
    if (both) {
      times.t_s.insert(times.t_s.end(), piece.t_s.begin(), piece.t_s.end());
      times.host_s.insert(times.host_s.end(), piece.host_s.begin(), piece.host_s.end());
    } else {
      if (times.t_s.size() < 2) times.t_s.assign(2, piece.t_s.front());
      times.t_s.back() = piece.t_s.back();
    }
  }

  const MappedFile& file_;
  const char* last_ = nullptr;
};

}  // namespace

std::optional<OpenedRecording> open_mcap(const std::filesystem::path& path) {
  const MappedFile file(path);
  Facts facts(file);
  const Ending ending = read(file.bytes(), facts);
  const bool two_clocks = facts.two_clocks();
  facts.pieces.hand_on();
  Collector& found = facts.found;
  if (ending.end == End::unfit || !found.settings || two_clocks != facts.two_clocks())
    throw NotInOrder();
  const Settings settings = *found.settings;
  if (!settings.devices.empty()) return std::nullopt;
  if (settings.module.sorted && !settings.module.sorted->restarts.empty()) throw NotInOrder();
  OpenedRecording out{
      assembled(found, ending, file.bytes().size()),
      std::make_unique<McapModuleRows>(path, ending.valid_bytes, facts.pieces.names())};
  Recording& recording = out.recording;
  facts.times.name = recording.module.name;
  recording.module =
      stream_in_order(std::move(facts.times), facts.pieces.run(), found.module, settings.module);
  refuse_unusable(recording, true, path.string());
  name_after(path, recording);
  return out;
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
