#include "acquisition/clock/synchronise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "acquisition/clock/align_velocity.h"
#include "acquisition/clock/device_track.h"
#include "acquisition/clock/doubt.h"
#include "acquisition/clock/run_maps.h"

namespace searig::acquisition {
namespace {

constexpr double kHiddenLatency = 0.004;  // s, the most an undeclared fixed latency is taken to be

/// How far the fixed latencies may be off that pings do not show, together.
double hidden_s(const Recording& recording, const DeviceTrack& module,
                const DeviceTrack& loadcell) {
  const auto of = [](const Stream& stream, const DeviceTrack& track) {
    if (track.pinged) return 0.0;
    return stream.host_latency ? stream.host_latency->ci95_s : 0.5 * kHiddenLatency;
  };
  const double m = of(recording.module, module), l = of(recording.loadcell, loadcell);
  const bool nothing_known = !module.pinged && !loadcell.pinged && !recording.module.host_latency &&
                             !recording.loadcell.host_latency;
  return nothing_known ? m + l : std::hypot(m, l);
}

/// What a latency is taken for without pings. That of both is the same, if nothing is known.
double latency_of(const Stream& stream) {
  return stream.host_latency ? stream.host_latency->latency_s : 0.5 * kHiddenLatency;
}

/// How well a device's time is placed on the host's clock, near a device time.
double placed_s(const DeviceTrack& track, double t_s) {
  return track.pinged ? track.pinged->ci95_s(t_s) : track.line.ci95_s();
}

/// One sentence for a map that is trusted.
std::string evidence(const DeviceTrack& module, double module_ci_s, const DeviceTrack& loadcell,
                     double loadcell_ci_s, double seen_s, double hidden_s) {
  if (!module.pinged || !loadcell.pinged)
    return printed(
        "the arrivals place the two clocks within %.3f ms; the fixed part of a one-way latency, "
        "which they cannot show, may hide %.1f ms more.",
        1e3 * seen_s, 1e3 * hidden_s);
  const char* const bent = module.bent() || loadcell.bent()
                               ? "; the clocks run unevenly and are followed piece by piece."
                               : ".";
  return printed(
             "two-way pings place the module's clock within %.3f ms and the load cell's "
             "within %.3f ms",
             1e3 * module_ci_s, 1e3 * loadcell_ci_s) +
         bent;
}

/// The device time in the middle of a run.
double middle_of(const Stream& stream, const Run& run) {
  return 0.5 * (stream.t_s[run.first] + stream.t_s[run.last - 1]);
}

/// Both streams on one clock. A restart without host stamps leaves only one run to use: how long
/// the device was away nobody knows.
ClockMap on_one_clock(const Recording& recording) {
  ClockMap map;
  const std::vector<Run> module = runs_of(recording.module);
  const std::vector<Run> loadcell = runs_of(recording.loadcell);
  const std::size_t of_module = longest_run(recording.module);
  const std::size_t of_loadcell =
      module.size() == loadcell.size() ? of_module : longest_run(recording.loadcell);
  map.module_runs.push_back(as_it_is(module[of_module]));
  map.loadcell_runs.push_back(as_it_is(loadcell[of_loadcell]));
  map.why = "both streams are on one clock";
  if (module.size() > 1 || loadcell.size() > 1)
    map.why += printed(
        "; it began anew (%.0f times) without host stamps, so only the longest run of "
        "%.0f rows can be used",
        double(std::max(module.size(), loadcell.size()) - 1), double(module[of_module].size()));
  map.trusted = module.size() == loadcell.size();
  const auto& m = recording.module.t_s;
  const auto& l = recording.loadcell.t_s;
  if (map.trusted && module.size() == 1 && (l.front() > m.back() || m.front() > l.back())) {
    map.trusted = false;  // two clocks that somebody forgot to stamp look like this
    map.why =
        "without host stamps in both the streams are on one clock, and on it "
        "they never ran at the same time";
  }
  map.why += ".";
  return map;
}

/// Without stamps: the longest runs of both hold the motion that both saw.
ClockMap by_velocity(const Stream& module, const Stream& device) {
  const auto part = [](const Stream& stream, const std::vector<double>& values) {
    const Run run = runs_of(stream)[longest_run(stream)];
    return std::span(values).subspan(run.first, run.size());
  };
  const auto& input = device.channel("input_angle_rad");
  const Alignment found = align_by_velocity(
      part(module, module.t_s), part(module, module.channel("input_velocity_rad_s")),
      part(device, device.t_s),
      part(device, input.empty() ? device.channel("motor_angle_rad") : input));
  ClockMap map{found.rate, found.offset_s, found.ci95_s, found.trusted, found.why, {}, {}};
  const Run run = runs_of(device)[longest_run(device)];
  map.module_runs.push_back(as_it_is(runs_of(module)[longest_run(module)]));
  map.loadcell_runs.push_back({run.first, run.last, found.rate, found.offset_s});
  return map;
}

}  // namespace

ClockMap synchronise(const Recording& recording) {
  if (recording.loadcell.t_s.empty()) {  // a module's own log
    ClockMap map;
    map.module_runs.push_back(as_it_is(runs_of(recording.module)[longest_run(recording.module)]));
    map.trusted = false;
    map.why = "there is no load cell.";
    return map;
  }
  if (recording.one_clock || recording.module.host_s.empty() || recording.loadcell.host_s.empty())
    return on_one_clock(recording);

  const auto module = device_tracks(recording.module, latency_of(recording.module));
  const auto loadcell = device_tracks(recording.loadcell, latency_of(recording.loadcell));
  const DeviceTrack& module_main = module[longest_run(recording.module)];
  const DeviceTrack& loadcell_main = loadcell[longest_run(recording.loadcell)];

  ClockMap map;
  const auto add = [&](std::vector<RunMap>& runs, const Stream& stream, const DeviceTrack& track) {
    for (const RunMap& piece : through_host(stream.t_s, track, module_main)) runs.push_back(piece);
  };
  for (const DeviceTrack& track : module) {
    if (&track == &module_main)
      map.module_runs.push_back(as_it_is(track.run));
    else
      add(map.module_runs, recording.module, track);
  }
  for (const DeviceTrack& track : loadcell) add(map.loadcell_runs, recording.loadcell, track);

  const double middle_s = middle_of(recording.loadcell, loadcell_main.run);
  const double module_s = module_main.device(loadcell_main.host(middle_s));
  map.rate = loadcell_main.line.rate() / module_main.line.rate();
  map.offset_s = module_s - map.rate * middle_s;
  const double module_ci_s = placed_s(module_main, module_s);
  const double loadcell_ci_s = placed_s(loadcell_main, middle_s);
  // Bounds add up; what is seen of latencies is by chance.
  const double seen_s = module_main.pinged || loadcell_main.pinged
                            ? module_ci_s + loadcell_ci_s
                            : std::hypot(module_ci_s, loadcell_ci_s);
  const double hidden = hidden_s(recording, module_main, loadcell_main);
  map.ci95_s = hidden + seen_s;

  std::string reason = doubt(recording.module, module_main);
  if (reason.empty()) reason = doubt(recording.loadcell, loadcell_main);
  if (reason.empty() && !heard_together(recording.module, recording.loadcell))
    reason = "the two streams were never received at the same time";
  map.trusted = reason.empty();
  map.why = map.trusted
                ? evidence(module_main, module_ci_s, loadcell_main, loadcell_ci_s, seen_s, hidden)
                : reason + ".";
  return map;
}

ClockMap synchronise(const Recording& recording, const Device& device) {
  if (device.aligned_by == AlignedBy::velocity) return by_velocity(recording.module, device.stream);
  Recording pair;
  pair.module = recording.module;
  pair.loadcell = device.stream;
  pair.one_clock = device.aligned_by == AlignedBy::clock;
  return synchronise(pair);
}

std::vector<double> on_module_clock(const Stream& stream, const std::vector<RunMap>& runs) {
  std::vector<double> module_s(stream.t_s.size(), std::numeric_limits<double>::quiet_NaN());
  for (const RunMap& run : runs)
    for (std::size_t row = run.first; row < run.last; ++row)
      module_s[row] = run.rate * stream.t_s[row] + run.offset_s;
  return module_s;
}

}  // namespace searig::acquisition
