// Reasons not to trust a clock map.
#pragma once

#include <string>

#include "acquisition/clock/device_track.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// Why this track of a stream cannot be trusted, as the rest of a sentence; empty where it can.
std::string doubt(const Stream& stream, const DeviceTrack& track);

/// Whether two streams were received at the same time, at least in part.
bool heard_together(const Stream& a, const Stream& b);

/// printf into a string, for the figures in a reason.
std::string printed(const char* format, double a, double b = 0.0);

}  // namespace searig::acquisition
