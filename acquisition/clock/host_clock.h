// One run of a device clock held against the host's: the line under its arrivals.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "acquisition/clock/host_timer.h"
#include "acquisition/clock/hull.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition {

constexpr double kShortRun = 5.0;     ///< s, below which a rate cannot be told from latency
constexpr std::size_t kFewRows = 50;  ///< below which the floor of the latencies may be missed

/// Rows [first, last) of a stream between two restarts.
struct Run {
  std::size_t first = 0;
  std::size_t last = 0;
  std::size_t size() const { return last - first; }
};

/// The runs of a stream, at least one.
std::vector<Run> runs_of(const Stream& stream);

/// The run of a stream that lasts longest on the device clock.
std::size_t longest_run(const Stream& stream);

/// Earliest possible arrival of what happened at device time t:
///   host = t + delay(t),
/// delay being a line below every arrival. It still holds the fixed part of the latency.
struct HostLine {
  Line delay;
  double seconds = 0.0;           ///< length of the run
  std::size_t rows = 0;           ///< how many arrivals it rests on
  double halves_apart_s = 0.0;    ///< how far the lines of its two halves differ at its middle
  double floor_s = 0.0;           ///< how far above the line the arrivals next to it lie
  double lowest_percent_s = 0.0;  ///< and one arrival in a hundred
  double median_s = 0.0;          ///< and the middle one
  Timer timer = Timer::absent;    ///< the host's, see host_timer.h
  double unseen_wait_s = 0.0;     ///< of it; half is taken off the line where the timer is heard

  double host(double t_s) const { return t_s + delay(t_s); }
  double rate() const { return 1.0 + delay.slope; }

  /// Half width of the 95 % interval of the line at the middle of the run, without the latency's
  /// fixed part: what its halves disagree by, how thin the arrivals lie near the floor, and what
  /// was not seen of the wait for the host's timer.
  double ci95_s() const;
};

/// The line under the arrivals of a run. t_s must rise; both of one size, at least 1.
HostLine fit_host_line(std::span<const double> t_s, std::span<const double> host_s);

/// The same for a run too short to show its own rate: the rate is given (same device, same quartz).
HostLine fit_host_line(std::span<const double> t_s, std::span<const double> host_s, double slope);

}  // namespace searig::acquisition
