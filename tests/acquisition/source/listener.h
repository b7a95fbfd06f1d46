// Listens to sources as a recorder does, and keeps what came.
#pragma once

#include <algorithm>
#include <vector>

#include "acquisition/clock/host_clock.h"
#include "acquisition/source/decode.h"
#include "acquisition/wire/encode.h"

namespace searig::acquisition {

struct Listener {
  explicit Listener(std::unique_ptr<Source> from)
      : source(std::move(from)), decoder(decoder_for(source->name())) {}

  /// Listens until `enough` says so, or for as long as it takes a broken thing to be called broken.
  template <typename Enough>
  bool until(Enough enough, double at_most_s = 20.0) {
    const double end_s = host_now_s() + at_most_s;
    while (!enough()) {
      if (host_now_s() > end_s) return false;
      round(std::min(0.1, end_s - host_now_s()));
    }
    return true;
  }

  void for_seconds(double seconds) {
    const double end_s = host_now_s() + seconds;
    while (host_now_s() < end_s) round(std::max(0.0, end_s - host_now_s()));
  }

  void round(double timeout_s) {
    ++rounds;
    Source* const one[] = {source.get()};
    wait_for(one, timeout_s);
    arrivals.clear();
    source->read(arrivals);
    for (const Arrival& arrival : arrivals) {
      decode(arrival, decoder, messages);
      if (arrival.kind != Arrival::Kind::bytes) events.push_back(arrival);
    }
  }

  template <typename T>
  std::vector<T> all() const {
    std::vector<T> found;
    for (const Message& message : messages) {
      if (const T* one = std::get_if<T>(&message)) found.push_back(*one);
    }
    return found;
  }

  std::vector<Arrival::Kind> kinds() const {
    std::vector<Arrival::Kind> kinds;
    for (const Arrival& event : events) kinds.push_back(event.kind);
    return kinds;
  }

  std::uint64_t damaged() const {
    const ParserCounters& parser = decoder.counters().parser;
    return parser.bad_crc + parser.malformed + parser.too_long;
  }

  /// How much faster the load cell's clock runs than the host's, by the line under the arrivals.
  double skew_ppm() const {
    std::vector<double> sent_s, host_s;
    for (const auto& sample : all<LoadcellSample>()) {
      if (sample.repeated) continue;  // its age may be longer than can be said
      sent_s.push_back(sample.sent_s);
      host_s.push_back(sample.at.host_s);
    }
    return (1.0 / fit_host_line(sent_s, host_s).rate() - 1.0) * 1e6;
  }

  std::unique_ptr<Source> source;
  Decoder decoder;
  std::vector<Arrival> arrivals;
  std::vector<Arrival> events;
  std::vector<Message> messages;
  std::size_t rounds = 0;
};

}  // namespace searig::acquisition
