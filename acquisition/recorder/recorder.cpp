#include "acquisition/recorder/recorder.h"

#include <array>
#include <cstdio>
#include <stdexcept>
#include <utility>

#include "acquisition/recorder/priority.h"
#include "acquisition/wire/encode.h"

namespace searig::acquisition {
namespace {

constexpr double tell_every_s = 1.0;
constexpr double ping_every_s = 0.5;
constexpr double progress_every_s = 0.2;
constexpr double doze_s = 0.05;  // at most so long without a look at the clock and at `stop`

Framing framing_of(const Source& source) {
  return source.name().starts_with("udp:") ? Framing::datagrams : Framing::stream;
}

std::string kept(double seconds) {
  char words[80];
  std::snprintf(words, sizeof words, " The %.1f s until then are kept.", seconds);
  return words;
}

}  // namespace

Recorder::Line::Line(StreamId which, std::unique_ptr<Source> from,
                     std::optional<CountsToForce> calibration)
    : device(which), source(std::move(from)), stream(which, framing_of(*source), calibration) {}

Recorder::Recorder(RecorderOptions options, std::unique_ptr<Source> module,
                   std::unique_ptr<Source> loadcell)
    : options_(std::move(options)),
      file_(options_.file),
      module_(StreamId::module, std::move(module), std::nullopt),
      loadcell_(StreamId::loadcell, std::move(loadcell), options_.loadcell),
      started_s_(host_now_s()) {
  settings_.program = options_.file.program;
  settings_.started = options_.started;
  settings_.lever_arm_m = options_.lever_arm_m.value_or(1.0);
  settings_.calibration = options_.calibration;
  settings_.module.source = module_.source->name();
  settings_.loadcell.source = loadcell_.source->name();
  entries_.push_back(NewSettings{started_s_, settings_});
  if (!options_.lever_arm_m)
    entries_.push_back(Event{started_s_, "loadcell", "lever arm",
                             "The lever arm was not given: it is taken as 1 m."});
}

RecorderState Recorder::run(const std::atomic<bool>& stop,
                            const std::function<void(const RecorderState&)>& progress) {
  prefer_this_thread();
  const std::array<Source*, 2> sources{module_.source.get(), loadcell_.source.get()};
  double tell_s = started_s_ + tell_every_s, ping_s = started_s_, progress_s = started_s_;
  double now_s = started_s_;
  while (!stop && now_s < started_s_ + options_.seconds && file_.failure().empty()) {
    const double end_s = started_s_ + options_.seconds;
    wait_for(sources, std::min(doze_s, std::max(0.0, end_s - now_s)));
    read(module_);
    read(loadcell_);
    now_s = host_now_s();
    if (now_s >= ping_s) {
      ask(module_, now_s);
      ask(loadcell_, now_s);
      ping_s = now_s + ping_every_s;
    }
    if (now_s >= tell_s) {
      tell(now_s);
      tell_s += tell_every_s;
    }
    settle(now_s);
    hand_over(now_s);
    if (progress && now_s >= progress_s) {
      progress(state(now_s));
      progress_s = now_s + progress_every_s;
    }
  }
  tell(now_s);
  hand_over(now_s);
  file_.finish();
  if (const std::string why = file_.failure(); !why.empty())
    throw std::runtime_error(why + kept(now_s - started_s_));
  refuse_silence(module_);
  refuse_silence(loadcell_);
  return state(now_s);
}

void Recorder::read(Line& line) {
  line.arrivals.clear();
  line.source->read(line.arrivals);
  for (const Arrival& arrival : line.arrivals) {
    line.stream.take(arrival, entries_);
    if (arrival.kind == Arrival::Kind::unusable || arrival.kind == Arrival::Kind::unplugged)
      line.trouble = arrival.what;
    if (arrival.kind == Arrival::Kind::connected || arrival.kind == Arrival::Kind::reconnected)
      line.source->send(identify_frame());
  }
}

/// A ping, for the clocks; and who it is, as long as that is not known.
void Recorder::ask(Line& line, double now_s) {
  if (line.source->handle() < 0) return;
  if (!line.stream.identity()) line.source->send(identify_frame());
  line.source->send(ping_frame(line.pings++, now_s));
}

void Recorder::tell(double now_s) {
  module_.stream.tell(now_s, module_.source->counters(), entries_);
  loadcell_.stream.tell(now_s, loadcell_.source->counters(), entries_);
}

/// What the devices say of themselves, once they have.
void Recorder::settle(double now_s) {
  const auto describe = [](const Line& line, mcap::StreamSettings& settings) {
    const auto& identity = line.stream.identity();
    if (!identity) return false;
    const std::string words =
        identity->name + ", firmware " + std::to_string(identity->firmware_version);
    return std::exchange(settings.device, words) != words;
  };
  bool news = describe(module_, settings_.module);
  news = describe(loadcell_, settings_.loadcell) || news;
  if (!news) return;
  if (const auto& module = module_.stream.identity(); module && module->gear_ratio > 0.0)
    settings_.gear_ratio = module->gear_ratio;
  entries_.push_back(NewSettings{now_s, settings_});
}

void Recorder::hand_over(double now_s) {
  const std::size_t gone = file_.push(entries_);
  if (gone == 0 && overflown_ > 0) {
    entries_.push_back(Event{now_s, "", "overflow",
                             "The disk was too slow: " + std::to_string(overflown_) +
                                 " entries of what came are not in this file."});
    overflown_ = 0;
  }
  overflown_ += gone;
}

RecorderState Recorder::state(double now_s) const {
  return {now_s - started_s_, module_.stream.counters(), loadcell_.stream.counters(), file_.clock(),
          file_.bytes_written()};
}

void Recorder::refuse_silence(const Line& line) const {
  if (line.stream.counters().samples > 0) return;
  throw std::runtime_error(options_.file.path.string() + ": no sample came from the " +
                           (line.device == StreamId::module ? "module" : "load cell") + " (" +
                           line.source->name() + ")" +
                           (line.trouble.empty() ? "." : ": " + line.trouble));
}

}  // namespace searig::acquisition
