#include "app/session/device_channels.h"

#include <algorithm>

#include "acquisition/clock/device_clock.h"
#include "estimator/model/predict.h"

namespace searig::app {
namespace {

using acquisition::ClockMap;
using acquisition::PlacedRows;
using acquisition::Recording;

constexpr double kPause = 10.0;  // samples of a device

bool covers(const std::vector<double>& device_s, double pause_s, double t_s) {
  const auto after = std::ranges::lower_bound(device_s, t_s);
  if (after == device_s.end()) return false;
  if (*after == t_s) return true;
  return after != device_s.begin() && *after - *(after - 1) <= pause_s;
}

}  // namespace

PlacedRows covered_rows(const Recording& recording, const std::vector<ClockMap>& devices,
                        PlacedRows module) {
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const PlacedRows device =
        acquisition::place_rows(recording.devices[i].stream, devices[i].loadcell_runs);
    const double pause_s = kPause * acquisition::median_step(device.t_s);
    PlacedRows kept;
    for (std::size_t row = 0; row < module.rows.size(); ++row) {
      if (!covers(device.t_s, pause_s, module.t_s[row])) continue;
      kept.rows.push_back(module.rows[row]);
      kept.t_s.push_back(module.t_s[row]);
    }
    module = std::move(kept);
  }
  return module;
}

std::vector<acquisition::Channel> device_channels(const Recording& recording,
                                                  const std::vector<ClockMap>& devices,
                                                  const PlacedRows& module) {
  std::vector<acquisition::Channel> out;
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const auto& stream = recording.devices[i].stream;
    const PlacedRows device = acquisition::place_rows(stream, devices[i].loadcell_runs);
    for (const acquisition::Channel& channel : stream.channels)
      out.push_back({channel.name,
                     estimator::sample_at(device.t_s, acquisition::at_rows(channel.values, device),
                                          module.t_s)});
  }
  return out;
}

}  // namespace searig::app
