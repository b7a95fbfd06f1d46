#include "app/rig/live_signals.h"

#include <algorithm>
#include <string_view>
#include <variant>

namespace searig::app {
namespace {

using acquisition::StreamId;

std::size_t place_of(const acquisition::Columns& columns, std::string_view name) {
  const auto found = std::find(columns.names.begin(), columns.names.end(), name);
  return found == columns.names.end() ? 0 : std::size_t(found - columns.names.begin());
}

}  // namespace

void LiveSignals::take(const std::vector<acquisition::Entry>& entries) {
  for (const acquisition::Entry& entry : entries) {
    if (const auto* columns = std::get_if<acquisition::Columns>(&entry)) take(*columns);
    if (const auto* row = std::get_if<acquisition::SampleRow>(&entry)) take(*row);
  }
}

void LiveSignals::take(const acquisition::Columns& columns) {
  if (columns.device == StreamId::loadcell) {
    force_ = place_of(columns, "force_n");
    return;
  }
  estimator::ModuleSignals& module = signals_.module;
  input_ = place_of(columns, "input_angle_rad");
  output_ = place_of(columns, "output_angle_rad");
  for (const auto& [name, channel] : {std::pair{"input_angle_rad", &module.input_angle_rad},
                                      {"output_angle_rad", &module.output_angle_rad},
                                      {"current_a", &module.current_a},
                                      {"commanded_angle_rad", &module.commanded_angle_rad},
                                      {"input_velocity_rad_s", &module.input_velocity_rad_s},
                                      {"winding_temperature_c", &module.winding_temperature_c},
                                      {"spring_temperature_c", &module.spring_temperature_c}})
    if (const std::size_t place = place_of(columns, name); place != 0)
      module_channels_.emplace_back(place, channel);
}

void LiveSignals::take(const acquisition::SampleRow& row) {
  if (row.device == StreamId::loadcell) {
    if (force_ == 0) return;
    loadcell_s_.push_back(row.t_s());
    signals_.loadcell.torque_nm.push_back(row.values[force_] * lever_arm_m_);
    signals_.loadcell.t_s.push_back(map_.to_module(row.t_s()));
    return;
  }
  estimator::ModuleSignals& module = signals_.module;
  module.t_s.push_back(row.t_s());
  for (const auto& [place, channel] : module_channels_) channel->push_back(row.values[place]);
  if (input_ != 0 && output_ != 0)
    module.deflection_rad.push_back(row.values[input_] - row.values[output_]);
}

void LiveSignals::place(const acquisition::ClockMap& map) {
  map_ = map;
  signals_.clock_ci95_s = map.ci95_s;
  for (std::size_t i = 0; i < loadcell_s_.size(); ++i)
    signals_.loadcell.t_s[i] = map.to_module(loadcell_s_[i]);
}

}  // namespace searig::app
