#include <algorithm>
#include <cmath>
#include <utility>

#include "acquisition/recording/mapped_file.h"
#include "acquisition/recording/mcap/collector.h"
#include "acquisition/recording/mcap/layout.h"
#include "acquisition/recording/mcap/read_mcap.h"

namespace searig::acquisition::mcap {
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

}  // namespace searig::acquisition::mcap
