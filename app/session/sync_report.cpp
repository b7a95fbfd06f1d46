#include "app/session/sync_report.h"

#include "app/session/stream_facts.h"

namespace searig::app {

nlohmann::json map_json(const acquisition::ClockMap& map) {
  return {{"rate", map.rate}, {"offset_s", map.offset_s}, {"ci95_s", map.ci95_s}};
}

nlohmann::json sync_report(const acquisition::Recording& recording,
                           const acquisition::ClockMap& map,
                           const std::vector<acquisition::ClockMap>& devices) {
  nlohmann::json out{{"format", "searig-sync/1"},
                     {"loadcell_to_module", map_json(map)},
                     {"trusted", map.trusted},
                     {"why", map.why},
                     {"streams", {stream_json(recording.module), stream_json(recording.loadcell)}}};
  for (std::size_t i = 0; i < devices.size(); ++i) {
    out["devices"].push_back({{"name", recording.devices[i].stream.name},
                              {"to_module", map_json(devices[i])},
                              {"trusted", devices[i].trusted},
                              {"why", devices[i].why}});
    out["streams"].push_back(stream_json(recording.devices[i].stream));
  }
  return out;
}

}  // namespace searig::app
