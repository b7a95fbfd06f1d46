#include "acquisition/recorder/line.h"

#include <array>
#include <utility>

#include "acquisition/recorder/priority.h"
#include "acquisition/source/decode.h"
#include "acquisition/wire/encode.h"

namespace searig::acquisition {
namespace {

constexpr double tell_every_s = 1.0;
constexpr double ping_every_s = 0.5;
constexpr double doze_s = 0.05;  // at most so long without a look at `stop`

}  // namespace

Line::Line(StreamId device, std::unique_ptr<Source> source,
           std::optional<CountsToForce> calibration, FileThread& file)
    : device_(device),
      source_(std::move(source)),
      name_(source_->name()),
      stream_(device, framing_of(name_), calibration),
      file_(file) {}

Line::~Line() {
  stop();
}

void Line::start() {
  thread_ = std::thread([this] { run(); });
}

void Line::stop() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void Line::run() {
  prefer_this_thread();
  const std::array<Source*, 1> sources{source_.get()};
  double now_s = host_now_s(), tell_s = now_s + tell_every_s, ping_s = now_s;
  while (!stop_) {
    wait_for(sources, doze_s);
    read();
    now_s = host_now_s();
    if (now_s >= ping_s) {
      ask(now_s);
      ping_s = now_s + ping_every_s;
    }
    if (now_s >= tell_s) {
      stream_.tell(now_s, source_->counters(), entries_);
      tell_s = now_s + tell_every_s;
    }
    hand_over(now_s);
    publish();
  }
  read();
  stream_.tell(host_now_s(), source_->counters(), entries_);
  hand_over(host_now_s());
  publish();
}

void Line::read() {
  arrivals_.clear();
  source_->read(arrivals_);
  for (const Arrival& arrival : arrivals_) {
    stream_.take(arrival, entries_);
    if (arrival.kind == Arrival::Kind::unusable || arrival.kind == Arrival::Kind::unplugged)
      trouble_ = arrival.what;
    if (arrival.kind == Arrival::Kind::connected || arrival.kind == Arrival::Kind::reconnected)
      source_->send(identify_frame());
  }
}

/// A ping, for the clocks; and who it is, as long as that is not known.
void Line::ask(double now_s) {
  if (source_->handle() < 0) return;
  if (!stream_.identity()) source_->send(identify_frame());
  source_->send(ping_frame(pings_++, now_s));
}

void Line::hand_over(double now_s) {
  const std::size_t gone = file_.push(entries_);
  if (gone == 0 && overflown_ > 0) {
    entries_.push_back(Event{now_s, mcap::name_of(device_), "overflow",
                             "The disk was too slow: " + std::to_string(overflown_) +
                                 " entries of what came are not in this file."});
    overflown_ = 0;
  }
  overflown_ += gone;
}

void Line::publish() {
  const std::lock_guard lock(mutex_);
  report_.counters = stream_.counters();
  if (stream_.identity() && !report_.identity) report_.identity = stream_.identity();
  if (report_.trouble != trouble_) report_.trouble = trouble_;
}

Line::Report Line::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

}  // namespace searig::acquisition
