// What a device can have done between two frames: how far its clock and its sequences may go.
#pragma once

#include <cstdint>

#include "acquisition/wire/frame_parser.h"

namespace searig::acquisition {

constexpr std::uint32_t kFewLost = 1000;  ///< frames that may be missing, whatever the time

/// Whether a device can have gone that far while the host went that far.
bool keep_time(double device_s, double host_s);

/// Whether so many frames of one type can have been left out in that time.
bool can_skip(std::uint32_t frames, double seconds);

/// Whether two frames that do not go on from what was, go on from each other.
bool go_together(const Frame& a, const Frame& b);

}  // namespace searig::acquisition
