#include "acquisition/recorder/rolling_clock.h"

#include <cstddef>

#include "acquisition/clock/ping_clock.h"

namespace searig::acquisition {
namespace {

constexpr std::size_t fewest = 50;  // samples of a stream

}  // namespace

/// Of an earlier run nothing bears on this one: the device's clock began anew.
void RollingClock::Window::begin(double new_run) {
  if (new_run == run) return;
  moments.clear();
  pings.clear();
  run = new_run;
}

void RollingClock::Window::take(const SampleRow& row) {
  begin(row.run());
  if (!moments.empty() && row.t_s() <= moments.back().t_s) return;  // a datagram came late
  moments.push_back({row.t_s(), row.host_s()});
  const double oldest_s = row.host_s() - window_s;
  while (moments.front().host_s < oldest_s) moments.pop_front();
  while (!pings.empty() && pings.front().host_received_s < oldest_s) pings.pop_front();
}

void RollingClock::Window::take(const PingRow& row) {
  const std::vector<double>& v = row.values;  // as ping_names has them
  begin(v[4]);
  pings.push_back({v[1], v[2], v[3], v[0], 0});
}

Stream RollingClock::Window::stream(const char* name) const {
  Stream stream;
  stream.name = name;
  for (const Moment& moment : moments) {
    stream.t_s.push_back(moment.t_s);
    stream.host_s.push_back(moment.host_s);
  }
  stream.counts.received = moments.size();
  stream.pings.assign(pings.begin(), pings.end());
  stream.least_wire_s = least_wire_s;
  return stream;
}

void RollingClock::take(const Entry& entry) {
  if (const auto* row = std::get_if<SampleRow>(&entry)) window(row->device).take(*row);
  if (const auto* row = std::get_if<PingRow>(&entry)) window(row->device).take(*row);
  if (const auto* known = std::get_if<NewSettings>(&entry))
    loadcell_.least_wire_s = least_ping_wire_s(known->settings.loadcell.baud);
}

std::optional<ClockMap> RollingClock::estimate() const {
  if (module_.moments.size() < fewest || loadcell_.moments.size() < fewest) return std::nullopt;
  Recording recording;
  recording.module = module_.stream("module");
  recording.loadcell = loadcell_.stream("loadcell");
  return synchronise(recording);
}

}  // namespace searig::acquisition
