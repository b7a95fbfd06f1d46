// A device's runs on the host's clock: by the line under their arrivals, and by pings where there
// are any.
#pragma once

#include <optional>
#include <vector>

#include "acquisition/clock/host_clock.h"
#include "acquisition/clock/pinged_run.h"

namespace searig::acquisition {

/// One run. The track is the line under the arrivals, latency_s earlier; where pings show that the
/// clock does not run so evenly (a resonator that warms), it bends through their moments instead.
struct DeviceTrack {
  Run run;
  HostLine line;
  std::optional<PingedRun> pinged;
  double latency_s = 0.0;  ///< the fixed part of the way: by pings, else as far as it is known

  bool bent() const { return pinged && !pinged->straight; }

  /// Host time at which happened what the device stamped so.
  double host(double t_s) const;
  /// And back.
  double device(double host_s) const;
};

/// The tracks of all runs of a stream with host stamps. Short runs borrow the rate of the longest,
/// and runs without pings its latency. latency_s: what to take it for where there are no pings.
std::vector<DeviceTrack> device_tracks(const Stream& stream, double latency_s);

}  // namespace searig::acquisition
