// What is known of a recording's clocks, for machines.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/recording.h"

namespace searig::app {

/// {"rate", "offset_s", "ci95_s"}: module time = rate * time + offset_s.
nlohmann::json map_json(const acquisition::ClockMap& map);

/// {"format": "searig-sync/1", "loadcell_to_module", "trusted", "why", "streams"}, with
/// {"devices": [{"name", "to_module": {...}, "trusted", "why"}]} where there are any.
nlohmann::json sync_report(const acquisition::Recording& recording,
                           const acquisition::ClockMap& map,
                           const std::vector<acquisition::ClockMap>& devices);

}  // namespace searig::app
