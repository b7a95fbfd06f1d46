#include "acquisition/clock/device_track.h"

#include <algorithm>
#include <span>

namespace searig::acquisition {
namespace {

/// theta through the moments, from each to the next in a straight line, beyond them as the whole.
double bent_theta(const PingedRun& pinged, double slope, double t_s) {
  const auto& moments = pinged.moments;
  const auto next =
      std::find_if(moments.begin(), moments.end(), [&](const auto& m) { return m.t_s > t_s; });
  if (next == moments.begin() || next == moments.end()) {
    const auto& end = next == moments.begin() ? moments.front() : moments.back();
    return end.theta_s + slope * (t_s - end.t_s);
  }
  const auto& a = *(next - 1);
  return a.theta_s + (next->theta_s - a.theta_s) * (t_s - a.t_s) / (next->t_s - a.t_s);
}

std::vector<Exchange> pings_of(const Stream& stream, std::size_t run) {
  std::vector<Exchange> pings;
  for (const Exchange& ping : stream.pings)
    if (ping.run == run) pings.push_back(ping);
  return pings;
}

}  // namespace

double DeviceTrack::host(double t_s) const {
  return bent() ? t_s + bent_theta(*pinged, line.delay.slope, t_s) : line.host(t_s) - latency_s;
}

double DeviceTrack::device(double host_s) const {
  if (!bent()) {
    const double origin = line.delay.at;  // near it, so that no digits are lost
    return origin + (host_s - (line.host(origin) - latency_s)) / line.rate();
  }
  // theta changes by less than 1 % of the time: each round brings it that much nearer.
  double t_s = host_s - pinged->moments.front().theta_s;
  for (int round = 0; round < 8; ++round) t_s = host_s - bent_theta(*pinged, line.delay.slope, t_s);
  return t_s;
}

std::vector<DeviceTrack> device_tracks(const Stream& stream, double latency_s) {
  const std::vector<Run> runs = runs_of(stream);
  const std::size_t longest = longest_run(stream);
  const auto part = [&](const std::vector<double>& values, std::size_t run) {
    return std::span(values).subspan(runs[run].first, runs[run].size());
  };
  const auto track = [&](std::size_t run, const HostLine& line) {
    DeviceTrack made{runs[run], line, std::nullopt, latency_s};
    if (!stream.host_latency)  // a latency that was declared is taken for what it is
      made.pinged = hold_against_pings(part(stream.t_s, run), part(stream.host_s, run),
                                       pings_of(stream, run), stream.least_wire_s, line.delay);
    return made;
  };
  const DeviceTrack main =
      track(longest, fit_host_line(part(stream.t_s, longest), part(stream.host_s, longest)));
  if (main.pinged) latency_s = main.pinged->latency_s;
  std::vector<DeviceTrack> tracks;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const auto t = part(stream.t_s, run), host = part(stream.host_s, run);
    const bool short_run = t.size() < kFewRows || t.back() - t.front() < 2.0 * kShortRun;
    tracks.push_back(run == longest ? main
                     : short_run    ? track(run, fit_host_line(t, host, main.line.delay.slope))
                                    : track(run, fit_host_line(t, host)));
    DeviceTrack& made = tracks.back();
    made.latency_s = made.pinged ? made.pinged->latency_s : latency_s;
  }
  return tracks;
}

}  // namespace searig::acquisition
