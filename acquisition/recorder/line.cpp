#include "acquisition/recorder/line.h"

#include <algorithm>
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

Line::Line(StreamId device, std::unique_ptr<Source> source)
    : device_(device), source_(std::move(source)), name_(source_->name()) {}

Line::~Line() {
  stop();
}

void Line::add(std::shared_ptr<Listener> listener) {
  const std::lock_guard lock(mutex_);
  if (!there_.empty()) listener->take({Arrival::Kind::connected, host_now_s(), {}, there_});
  listener->begin(source_->counters());
  listeners_.push_back(std::move(listener));
}

void Line::remove(const std::shared_ptr<Listener>& listener) {
  std::unique_lock lock(mutex_);
  const auto listens = [&] {
    return std::find(listeners_.begin(), listeners_.end(), listener) != listeners_.end();
  };
  if (!listens()) return;  // whoever it hands on to may be gone
  leaving_.push_back(listener);
  left_.wait(lock, [&] { return !running_ || !listens(); });
  std::erase(listeners_, listener);
  std::erase(leaving_, listener);
}

/// Who leaves gets the counters as they are now, and no more.
void Line::let_go(double now_s) {
  if (leaving_.empty()) return;
  for (const auto& leaving : std::exchange(leaving_, {})) {
    leaving->tell(now_s, source_->counters());
    leaving->hand_over(now_s);
    std::erase(listeners_, leaving);
  }
  left_.notify_all();
}

void Line::start() {
  if (thread_.joinable()) return;
  running_ = true;
  thread_ = std::thread([this] { run(); });
}

void Line::stop() {
  stop_ = true;
  if (thread_.joinable()) thread_.join();
}

void Line::run() {
  prefer_this_thread();
  const std::array<Source*, 1> sources{source_.get()};
  ping_s_ = host_now_s();
  tell_s_ = ping_s_ + tell_every_s;
  while (!stop_) {
    wait_for(sources, doze_s);
    look();
  }
  const std::lock_guard lock(mutex_);
  read();
  for (const auto& listener : listeners_) listener->tell(host_now_s(), source_->counters());
  hand_over(host_now_s());
  running_ = false;
  left_.notify_all();
}

void Line::look() {
  const std::lock_guard lock(mutex_);
  read();
  const double now_s = host_now_s();
  if (now_s >= ping_s_) {
    ask(now_s);
    ping_s_ = now_s + ping_every_s;
  }
  if (now_s >= tell_s_) {
    for (const auto& listener : listeners_) listener->tell(now_s, source_->counters());
    tell_s_ = now_s + tell_every_s;
  }
  hand_over(now_s);
  let_go(now_s);
}

void Line::read() {
  arrivals_.clear();
  source_->read(arrivals_);
  for (const Arrival& arrival : arrivals_) {
    using Kind = Arrival::Kind;
    for (const auto& listener : listeners_) listener->take(arrival);
    if (arrival.kind == Kind::unplugged) there_.clear();
    if (arrival.kind == Kind::connected || arrival.kind == Kind::reconnected) {
      there_ = arrival.what;
      source_->send(identify_frame());
    }
  }
}

/// A ping, for the clocks; and who it is, as long as a listener does not know.
void Line::ask(double now_s) {
  if (source_->handle() < 0) return;
  const auto knows = [](const auto& listener) { return listener->knows_device(); };
  if (!std::all_of(listeners_.begin(), listeners_.end(), knows)) source_->send(identify_frame());
  source_->send(ping_frame(pings_++, now_s));
}

void Line::hand_over(double now_s) {
  for (const auto& listener : listeners_) listener->hand_over(now_s);
}

}  // namespace searig::acquisition
