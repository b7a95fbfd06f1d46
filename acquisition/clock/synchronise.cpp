#include "acquisition/clock/synchronise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "acquisition/clock/align_velocity.h"
#include "acquisition/clock/doubt.h"
#include "acquisition/clock/host_clock.h"

namespace searig::acquisition {
namespace {

constexpr double kHiddenLatency = 0.004;  // s, the most an undeclared fixed latency is taken to be

/// The host lines of all runs of a stream; short runs borrow the rate of the longest.
std::vector<HostLine> host_lines(const Stream& stream) {
  const std::vector<Run> runs = runs_of(stream);
  const std::size_t longest = longest_run(stream);
  const auto part = [&](const std::vector<double>& values, std::size_t run) {
    return std::span(values).subspan(runs[run].first, runs[run].size());
  };
  const HostLine main = fit_host_line(part(stream.t_s, longest), part(stream.host_s, longest));
  std::vector<HostLine> lines;
  for (std::size_t run = 0; run < runs.size(); ++run) {
    const auto t = part(stream.t_s, run), host = part(stream.host_s, run);
    const bool short_run = t.size() < kFewRows || t.back() - t.front() < 2.0 * kShortRun;
    lines.push_back(run == longest ? main
                    : short_run    ? fit_host_line(t, host, main.delay.slope)
                                   : fit_host_line(t, host));
  }
  return lines;
}

/// device time -> host time of the event -> module time, as one line over a run.
RunMap through_host(const Run& run, const HostLine& device, double device_latency,
                    const HostLine& module, double module_latency) {
  const double at = device.delay.at;
  const double host = device.host(at) - device_latency;
  const double origin = module.delay.at;
  const double module_s = origin + (host - (module.host(origin) - module_latency)) / module.rate();
  const double rate = device.rate() / module.rate();
  return {run.first, run.last, rate, module_s - rate * at};
}

/// What is known of the two fixed latencies, and how far their difference may be off.
struct Latencies {
  double module_s = 0.0;
  double loadcell_s = 0.0;
  double ci95_s = kHiddenLatency;
};

Latencies latencies(const Recording& recording) {
  const auto& module = recording.module.host_latency;
  const auto& loadcell = recording.loadcell.host_latency;
  if (!module && !loadcell) return {};  // the same for both is the best guess there is
  const HostLatency unknown{0.5 * kHiddenLatency, 0.5 * kHiddenLatency};
  const HostLatency m = module.value_or(unknown), l = loadcell.value_or(unknown);
  return {m.latency_s, l.latency_s, std::hypot(m.ci95_s, l.ci95_s)};
}

RunMap as_it_is(const Run& run) {
  return {run.first, run.last, 1.0, 0.0};
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
  if (recording.one_clock || recording.module.host_s.empty() || recording.loadcell.host_s.empty())
    return on_one_clock(recording);

  const std::vector<HostLine> module = host_lines(recording.module);
  const std::vector<HostLine> loadcell = host_lines(recording.loadcell);
  const HostLine& module_main = module[longest_run(recording.module)];
  const std::size_t loadcell_longest = longest_run(recording.loadcell);
  const HostLine& loadcell_main = loadcell[loadcell_longest];
  const Latencies latency = latencies(recording);

  ClockMap map;
  const std::vector<Run> module_runs = runs_of(recording.module);
  for (std::size_t run = 0; run < module.size(); ++run)
    map.module_runs.push_back(&module[run] == &module_main
                                  ? as_it_is(module_runs[run])
                                  : through_host(module_runs[run], module[run], latency.module_s,
                                                 module_main, latency.module_s));
  const std::vector<Run> loadcell_runs = runs_of(recording.loadcell);
  for (std::size_t run = 0; run < loadcell.size(); ++run)
    map.loadcell_runs.push_back(through_host(loadcell_runs[run], loadcell[run], latency.loadcell_s,
                                             module_main, latency.module_s));

  map.rate = map.loadcell_runs[loadcell_longest].rate;
  map.offset_s = map.loadcell_runs[loadcell_longest].offset_s;
  const double seen = std::hypot(module_main.ci95_s(), loadcell_main.ci95_s());
  map.ci95_s = latency.ci95_s + seen;

  std::string reason = doubt(recording.module, module_main);
  if (reason.empty()) reason = doubt(recording.loadcell, loadcell_main);
  if (reason.empty() && !heard_together(recording.module, recording.loadcell))
    reason = "the two streams were never received at the same time";
  map.trusted = reason.empty();
  map.why = map.trusted
                ? printed(
                      "the arrivals place the two clocks within %.3f ms; the fixed part of a "
                      "one-way latency, which they cannot show, may hide %.1f ms more.",
                      1e3 * seen, 1e3 * latency.ci95_s)
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
