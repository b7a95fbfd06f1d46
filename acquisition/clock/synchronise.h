// The load cell's clock brought to the module's, with an interval and a verdict.
#pragma once

#include <string>
#include <vector>

#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// Rows [first, last) of a stream between two restarts of its device, or a piece of them where its
/// clock runs unevenly: module time = rate * device time + offset_s.
struct RunMap {
  std::size_t first = 0;
  std::size_t last = 0;
  double rate = 1.0;
  double offset_s = 0.0;
};

/// module time = rate * loadcell time + offset_s
///
/// Where a device restarted, this is the map between the two longest runs, and module time is the
/// clock of the module's longest run; the other runs have maps of their own, through the host.
struct ClockMap {
  double rate = 1.0;
  double offset_s = 0.0;
  double ci95_s = 0.0;  ///< half width of the 95 % interval at the middle of the recording
  bool trusted = true;
  std::string why;  ///< one sentence: what the verdict rests on

  std::vector<RunMap> module_runs;    ///< runs that can be placed on the module's clock
  std::vector<RunMap> loadcell_runs;  ///< without host stamps only one pair of runs can

  double to_module(double loadcell_s) const { return rate * loadcell_s + offset_s; }
};

/// Maps the load cell's clock to the module's through the host's: each device's track
/// (clock/device_track.h), then one device through the host to the other. Live and batch.
///
/// The fixed part of a one-way latency shows in two-way pings (clock/ping_clock.h). In arrivals
/// alone it does not: undeclared, it is taken to lie between 0 and 4 ms in a stream without pings,
/// so that two of them may hide up to 4 ms either way; the interval includes it.
/// A map that cannot be trusted is still given, with the reason. Two streams on one clock, or
/// without host stamps in both, map onto each other as they are.
ClockMap synchronise(const Recording& recording);

/// The clock of a further device brought to the module's, as the recording says it is to be
/// aligned. The map is of the device's longest run; it is the device that stands where ClockMap
/// says load cell.
ClockMap synchronise(const Recording& recording, const Device& device);

/// A stream's rows on the module's clock, NaN where a row's run could not be placed.
std::vector<double> on_module_clock(const Stream& stream, const std::vector<RunMap>& runs);

}  // namespace searig::acquisition
