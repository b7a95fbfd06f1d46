#include "acquisition/clock/host_clock.h"

#include <algorithm>
#include <cmath>

namespace searig::acquisition {
namespace {

/// The line touches two arrivals; by this many further ones the floor shows how thin it is.
constexpr double kNextToFloor = 8.0;

/// The quantiles are taken over no more arrivals than this, evenly spread: a few hours of a fast
/// stream need not be in memory once more.
constexpr std::size_t kArrivals = 1 << 20;

/// How long after the device's time each row arrived, on two clocks.
struct Delays {
  std::span<const double> t_s, host_s;
  double operator[](std::size_t i) const { return host_s[i] - t_s[i]; }
};

double quantile(std::vector<double>& values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// Fills in how far the arrivals lie above the line, and lowers it by half the wait unseen.
HostLine judged(Line line, std::span<const double> t_s, std::span<const double> host_s) {
  const Delays delay{t_s, host_s};
  const std::size_t every = (t_s.size() + kArrivals - 1) / kArrivals;
  std::vector<double> above;
  above.reserve(t_s.size() / every + 1);
  for (std::size_t i = 0; i < t_s.size(); i += every) above.push_back(delay[i] - line(t_s[i]));
  HostLine fit;
  fit.seconds = t_s.back() - t_s.front();
  fit.rows = t_s.size();
  fit.median_s = quantile(above, 0.5);
  fit.lowest_percent_s = quantile(above, 0.01);
  fit.floor_s = quantile(above, std::min(1.0, kNextToFloor / static_cast<double>(above.size())));
  fit.timer = timer_in(t_s, host_s);
  if (fit.timer != Timer::absent) fit.unseen_wait_s = unseen_wait(above, kUsbTimer);
  if (fit.timer == Timer::heard) line.value -= 0.5 * fit.unseen_wait_s;
  fit.delay = line;
  return fit;
}

}  // namespace

std::vector<Run> runs_of(const Stream& stream) {
  std::vector<Run> runs;
  std::size_t first = 0;
  for (const std::size_t restart : stream.restarts) {
    runs.push_back({first, restart});
    first = restart;
  }
  runs.push_back({first, stream.t_s.size()});
  return runs;
}

std::size_t longest_run(const Stream& stream) {
  const std::vector<Run> runs = runs_of(stream);
  const auto seconds = [&](const Run& run) {
    return stream.t_s[run.last - 1] - stream.t_s[run.first];
  };
  return static_cast<std::size_t>(
      std::max_element(runs.begin(), runs.end(),
                       [&](const Run& a, const Run& b) { return seconds(a) < seconds(b); }) -
      runs.begin());
}

double HostLine::ci95_s() const {
  const double wait = timer == Timer::locked ? unseen_wait_s : 0.5 * unseen_wait_s;
  return halves_apart_s + floor_s + wait;
}

HostLine fit_host_line(std::span<const double> t_s, std::span<const double> host_s) {
  HostLine fit = judged(line_under(t_s, Delays{t_s, host_s}), t_s, host_s);
  const std::size_t half = t_s.size() / 2;
  if (half < 2) return fit;
  const auto line_of = [](std::span<const double> t, std::span<const double> host) {
    return line_under(t, Delays{t, host});
  };
  const Line early = line_of(t_s.first(half), host_s.first(half));
  const Line late = line_of(t_s.subspan(half), host_s.subspan(half));
  fit.halves_apart_s = std::abs(early(fit.delay.at) - late(fit.delay.at));
  return fit;
}

HostLine fit_host_line(std::span<const double> t_s, std::span<const double> host_s, double slope) {
  const double middle = 0.5 * (t_s.front() + t_s.back());
  return judged(line_under(t_s, Delays{t_s, host_s}, slope, middle), t_s, host_s);
}

}  // namespace searig::acquisition
