#include "acquisition/recorder/rolling_clock.h"

#include <cstddef>

namespace searig::acquisition {
namespace {

constexpr std::size_t fewest = 50;  // samples of a stream

}  // namespace

void RollingClock::Window::take(const SampleRow& row) {
  if (row.run() != run) moments.clear();  // its clock began anew
  run = row.run();
  if (!moments.empty() && row.t_s() <= moments.back().t_s) return;  // a datagram came late
  moments.push_back({row.t_s(), row.host_s()});
  while (moments.front().host_s < row.host_s() - window_s) moments.pop_front();
}

Stream RollingClock::Window::stream(const char* name) const {
  Stream stream;
  stream.name = name;
  for (const Moment& moment : moments) {
    stream.t_s.push_back(moment.t_s);
    stream.host_s.push_back(moment.host_s);
  }
  stream.counts.received = moments.size();
  return stream;
}

void RollingClock::take(const SampleRow& row) {
  (row.device == StreamId::module ? module_ : loadcell_).take(row);
}

std::optional<ClockMap> RollingClock::estimate() const {
  if (module_.moments.size() < fewest || loadcell_.moments.size() < fewest) return std::nullopt;
  Recording recording;
  recording.module = module_.stream("module");
  recording.loadcell = loadcell_.stream("loadcell");
  return synchronise(recording);
}

}  // namespace searig::acquisition
