#include "acquisition/recorder/listener.h"

namespace searig::acquisition {

void Listener::take(const Arrival& arrival) {
  using Kind = Arrival::Kind;
  if (arrival.kind == Kind::unusable || arrival.kind == Kind::unplugged) {
    trouble_ = arrival.what;
    connected_ = false;
  } else {
    connected_ = true;
  }
  stream_.take(arrival, entries_);
}

void Listener::tell(double now_s, const SourceCounters& source) {
  SourceCounters since = source;
  since.bytes -= before_.bytes;
  since.foreign -= before_.foreign;
  since.too_long -= before_.too_long;
  since.unplugged -= before_.unplugged;
  stream_.tell(now_s, since, entries_);
}

void Listener::hand_over(double now_s) {
  const std::size_t gone = sink_.push(entries_);
  if (gone == 0 && overflown_ > 0) {
    entries_.push_back(Event{now_s, mcap::name_of(device_), "overflow",
                             "The disk was too slow: " + std::to_string(overflown_) +
                                 " entries of what came are not in this file."});
    overflown_ = 0;
  }
  overflown_ += gone;
  publish();
}

void Listener::publish() {
  const std::lock_guard lock(mutex_);
  report_.counters = stream_.counters();
  if (stream_.identity() && !report_.identity) report_.identity = stream_.identity();
  if (report_.trouble != trouble_) report_.trouble = trouble_;
  report_.connected = connected_;
}

Listener::Report Listener::report() const {
  const std::lock_guard lock(mutex_);
  return report_;
}

}  // namespace searig::acquisition
