// From the runs of a device to the module's clock.
#pragma once

#include <vector>

#include "acquisition/clock/device_track.h"
#include "acquisition/clock/synchronise.h"

namespace searig::acquisition {

/// A run that is on the module's clock already.
RunMap as_it_is(const Run& run);

/// device time -> host time -> module time. One line over the run; piece by piece where one of the
/// two clocks runs unevenly, each as straight as a clock is over a few seconds. t_s: the stream's.
std::vector<RunMap> through_host(const std::vector<double>& t_s, const DeviceTrack& device,
                                 const DeviceTrack& module);

}  // namespace searig::acquisition
