#include "acquisition/clock/pinged_run.h"

#include <algorithm>
#include <cmath>

#include "acquisition/clock/ping_clock.h"

namespace searig::acquisition {
namespace {

constexpr double kMomentEvery = 10.0;  // s

/// Device times at which to ask: one in the middle of each of an odd number of equal parts, so that
/// the run's own middle is among them.
std::vector<double> times_to_ask(double from_s, double to_s) {
  const double parts = 2.0 * std::floor(0.5 * (to_s - from_s) / kMomentEvery) + 1.0;
  std::vector<double> times;
  for (double part = 0.5; part < parts; ++part)
    times.push_back(from_s + (to_s - from_s) * part / parts);
  return times;
}

/// The clock at each of these times, from what came up to half a window later.
std::vector<PingedRun::Moment> ask(std::span<const double> t_s, std::span<const double> host_s,
                                   std::span<const Exchange> pings, double least_wire_s,
                                   const Line& delay) {
  const PingClockOptions options{.least_there_s = least_wire_s, .least_back_s = least_wire_s};
  PingClock clock(options);
  const std::vector<double> times = times_to_ask(t_s.front(), t_s.back());
  std::vector<PingedRun::Moment> moments;
  auto next = times.begin();
  const auto answer_until = [&](double device_s) {
    for (; next != times.end() && *next <= device_s; ++next)
      if (const auto estimate = clock.at(*next))
        moments.push_back(
            {*next, estimate->theta_s, estimate->ci95_s, delay(*next) - estimate->theta_s});
  };
  auto ping = pings.begin();
  for (std::size_t row = 0; row < t_s.size(); ++row) {
    for (; ping != pings.end() && ping->host_received_s <= host_s[row]; ++ping) clock.take(*ping);
    answer_until(t_s[row] - 0.5 * options.window_s);
    // What is stamped at its reading leaves later still, so the bound holds all the more.
    clock.take_arrival(t_s[row], host_s[row], least_wire_s);
  }
  for (; ping != pings.end(); ++ping) clock.take(*ping);
  answer_until(t_s.back());
  return moments;
}

}  // namespace

double PingedRun::ci95_s(double t_s) const {
  const auto nearer = [&](const Moment& a, const Moment& b) {
    return std::abs(a.t_s - t_s) < std::abs(b.t_s - t_s);
  };
  const Moment& near = *std::min_element(moments.begin(), moments.end(), nearer);
  return near.ci95_s + (straight ? std::abs(near.late_s - latency_s) : 0.0);
}

std::optional<PingedRun> hold_against_pings(std::span<const double> t_s,
                                            std::span<const double> host_s,
                                            std::span<const Exchange> pings, double least_wire_s,
                                            const Line& delay) {
  if (pings.empty()) return std::nullopt;
  PingedRun run;
  run.moments = ask(t_s, host_s, pings, least_wire_s, delay);
  if (run.moments.empty() && least_wire_s > 0.0) run.moments = ask(t_s, host_s, pings, 0.0, delay);
  if (run.moments.empty()) return std::nullopt;

  std::vector<double> late;
  for (const PingedRun::Moment& moment : run.moments) late.push_back(moment.late_s);
  const auto middle = late.begin() + std::ssize(late) / 2;
  std::nth_element(late.begin(), middle, late.end());
  run.latency_s = *middle;
  run.straight = std::all_of(run.moments.begin(), run.moments.end(), [&](const auto& moment) {
    return std::abs(moment.late_s - run.latency_s) <= moment.ci95_s;
  });
  return run;
}

}  // namespace searig::acquisition
