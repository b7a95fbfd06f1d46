// A device's clock held against the host's while both run, by two-way exchanges: bounds, not
// guesses.
//
// theta(t) = host time - device time, at device time t. A ping that left the host at h and was
// whole at the device at t says theta(t) >= h - t + (least time of its way); an answer, or any
// other frame, that left the device at t and was at the host at h says theta(t) <= h - t - (least
// time of its way). theta is smooth: its rate of change changes by no more than `drift_per_s`. So
// every line that keeps to all bounds, each widened by drift_per_s/2 * (distance in time)^2, may be
// its tangent, and the truth is one of them. The middle of the lines' range is the estimate, half
// their range the interval: whatever part of the round trip is not known to be on one way or the
// other is in it.
#pragma once

#include <cstddef>
#include <deque>
#include <optional>

#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// The least time that bytes take on a serial line, s. 10 bits a byte; a 16 MHz Arduino makes
/// 117647 of 115200 baud, so a line may be that much faster than it is said to be.
inline double least_wire_s(std::size_t bytes, unsigned baud) {
  return baud == 0 ? 0.0 : 0.97 * 10.0 * static_cast<double>(bytes) / baud;
}

/// Of a ping, and of the pong, which is as long.
double least_ping_wire_s(unsigned baud);

struct PingClockOptions {
  double least_there_s = 0.0;     ///< a ping's way takes at least this long (its time on the wire)
  double least_back_s = 0.0;      ///< a pong's
  double drift_per_s = 0.3e-6;    ///< 1/s: a ceramic resonator (10 ppm/K) at 1.8 K/min
  double window_s = 60.0;         ///< what is older says nothing more
  double largest_skew = 6000e-6;  ///< of a device's clock; an Uno's was measured at 2021 ppm
};

/// host time = device time + theta_s + (rate - 1) * (device time - at_s), near at_s.
struct PingEstimate {
  double at_s = 0.0;       ///< device time
  double theta_s = 0.0;    ///< host time - device time, there
  double ci95_s = 0.0;     ///< half width; holds the truth surely, if the options are right
  double rate = 1.0;       ///< host seconds in a device second
  double rate_ci95 = 0.0;  ///< half width
};

class PingClock {
 public:
  explicit PingClock(const PingClockOptions& options = {}) : options_(options) {}

  /// In order of arrival, of one run of the device.
  void take(const Exchange& exchange);

  /// A frame that nobody asked for. least_s: its way takes at least this long.
  void take_arrival(double device_sent_s, double host_s, double least_s);

  /// The device began anew.
  void restart();

  /// The clock at a device time within the window or shortly behind it. Nothing where no exchange
  /// is in the window, or where the bounds contradict each other: then an option is wrong, or a
  /// time.
  std::optional<PingEstimate> at(double device_s) const;

 private:
  struct Bound {
    double t_s;  ///< device
    double theta_s;
  };
  void forget(double newest_s);
  double least(double slope, double at_s) const;
  double most(double slope, double at_s) const;
  double widened(const Bound& bound, double at_s) const;

  PingClockOptions options_;
  std::deque<Bound> from_below_;  ///< by pings
  std::deque<Bound> from_above_;  ///< by pongs and by the best arrival in each while
  double best_until_s_ = 0.0;     ///< end of the while that from_above_'s last arrival is best of
};

}  // namespace searig::acquisition
