// What came from the devices of a recording, as it came: for decoding it anew.
#pragma once

#include <functional>
#include <string_view>

#include "acquisition/recorder/entry.h"
#include "acquisition/recording/mcap/reader.h"
#include "acquisition/source/source.h"

namespace searig::acquisition {

using TakeArrival = std::function<void(StreamId device, const Arrival& arrival)>;

/// Hands on every arrival of both devices in the order of the file, bytes and what befell them.
/// Given to a DeviceStream they make the same samples as while they were recorded.
mcap::Ending replay(std::string_view file, const TakeArrival& take);

}  // namespace searig::acquisition
