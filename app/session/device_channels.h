// Channels that further devices supply, at the module's rows.
#pragma once

#include <vector>

#include "acquisition/clock/placed_rows.h"
#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/recording.h"

namespace searig::app {

/// Those rows of the module that every device covers: within its log, and not in a pause of it of
/// more than ten samples. Nothing is invented there.
acquisition::PlacedRows covered_rows(const acquisition::Recording& recording,
                                     const std::vector<acquisition::ClockMap>& devices,
                                     acquisition::PlacedRows module);

/// The devices' channels at those rows, along straight lines between their own.
std::vector<acquisition::Channel> device_channels(const acquisition::Recording& recording,
                                                  const std::vector<acquisition::ClockMap>& devices,
                                                  const acquisition::PlacedRows& module);

}  // namespace searig::app
