// A frame's payload in SI units.
#pragma once

#include "acquisition/wire/frame_parser.h"
#include "acquisition/wire/messages.h"
#include "acquisition/wire/unwrapped_time.h"

namespace searig::acquisition {

/// The frame's type must be one that a device sends; `time` follows the device's clock.
Message to_message(const Frame& frame, const Stamp& at, const UnwrappedTime& time);

}  // namespace searig::acquisition
