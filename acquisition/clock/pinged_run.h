// One run of a device held against its two-way pings: how late the line under its arrivals is.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "acquisition/clock/hull.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// What the pings of a run say of host time - device time, at moments about 10 s apart and at the
/// run's middle. Every interval holds the truth surely where PingClock's assumptions hold.
struct PingedRun {
  struct Moment {
    double t_s = 0.0;      ///< device time
    double theta_s = 0.0;  ///< host time - device time
    double ci95_s = 0.0;   ///< half width
    double late_s = 0.0;   ///< the line under the arrivals, less theta
  };
  std::vector<Moment> moments;  ///< in order of t_s, at least one
  double latency_s = 0.0;       ///< the line's, for the whole run: the middle one of late_s
  bool straight = true;         ///< whether that line, so much earlier, keeps within each interval

  /// Half width of the interval near a device time: of the line where it is straight, else of the
  /// moments' own thetas.
  double ci95_s(double t_s) const;
};

/// Nothing where no moment has pings that agree. delay: the line under host_s - t_s. A serial
/// line's least wire time is only used where the round trips leave room for it: behind native USB
/// there is no wire.
std::optional<PingedRun> hold_against_pings(std::span<const double> t_s,
                                            std::span<const double> host_s,
                                            std::span<const Exchange> pings, double least_wire_s,
                                            const Line& delay);

}  // namespace searig::acquisition
