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
  input_ = place_of(columns, "input_angle_rad");
  output_ = place_of(columns, "output_angle_rad");
  module_channels_.clear();  // a module that starts again tells them again
  for (const auto& [name, values] : estimator::module_channels)
    if (const std::size_t place = place_of(columns, name); place != 0)
      module_channels_.emplace_back(place, &(signals_.module.*values));
  computes_deflection_ = place_of(columns, "deflection_rad") == 0 && input_ != 0 && output_ != 0;
}

void LiveSignals::take(const acquisition::SampleRow& row) {
  row.device == StreamId::loadcell ? take_loadcell(row) : take_module(row);
}

void LiveSignals::take_loadcell(const acquisition::SampleRow& row) {
  if (force_ == 0) return;
  estimator::LoadcellSignals& loadcell = signals_.loadcell;
  if (row.run() != loadcell_run_) {  // the map was about the clock before
    loadcell_run_ = row.run();
    has_map_ = false;
    loadcell_s_.clear();
  }
  // Until the clocks are known, as if nothing took time on its way.
  const auto& module_s = signals_.module.t_s;
  if (!has_map_ && module_s.empty()) return;
  const double t_s = has_map_ ? map_.to_module(row.t_s()) + start_.shift_s
                              : module_s.back() + row.host_s() - start_.last_host_s;
  if (!loadcell.t_s.empty() && t_s <= loadcell.t_s.back()) return;
  loadcell_s_.push_back(row.t_s());
  loadcell.t_s.push_back(t_s);
  loadcell.torque_nm.push_back(row.values[force_] * lever_arm_m_);
}

void LiveSignals::take_module(const acquisition::SampleRow& row) {
  estimator::ModuleSignals& module = signals_.module;
  if (row.run() != start_.run && !module.t_s.empty()) {
    start_.shift_s = module.t_s.back() + (row.host_s() - start_.last_host_s) - row.t_s();
    has_map_ = false;  // it was about the clock before
    loadcell_s_.clear();
  }
  start_.run = row.run();
  const double t_s = row.t_s() + start_.shift_s;
  if (!module.t_s.empty() && t_s <= module.t_s.back()) return;
  start_.last_host_s = row.host_s();
  module.t_s.push_back(t_s);
  for (const auto& [place, channel] : module_channels_) channel->push_back(row.values[place]);
  if (computes_deflection_)
    module.deflection_rad.push_back(row.values[input_] - row.values[output_]);
}

void LiveSignals::place(const acquisition::ClockMap& map) {
  map_ = map;
  has_map_ = true;
  signals_.clock_ci95_s = map.ci95_s;
  auto& t_s = signals_.loadcell.t_s;
  const std::size_t first = t_s.size() - loadcell_s_.size();
  for (std::size_t i = 0; i < loadcell_s_.size(); ++i)
    t_s[first + i] = map.to_module(loadcell_s_[i]) + start_.shift_s;
}

std::vector<std::vector<double>*> LiveSignals::module_columns() {
  estimator::ModuleSignals& m = signals_.module;
  std::vector<std::vector<double>*> columns{&m.t_s};
  for (const auto& [place, channel] : module_channels_) columns.push_back(channel);
  if (computes_deflection_) columns.push_back(&m.deflection_rad);
  return columns;
}

std::size_t LiveSignals::keep_last(double seconds) {
  const auto older = [seconds](const std::vector<double>& t_s) {
    return t_s.empty()
               ? 0
               : std::lower_bound(t_s.begin(), t_s.end(), t_s.back() - seconds) - t_s.begin();
  };
  const auto module = older(signals_.module.t_s);
  for (auto* column : module_columns()) column->erase(column->begin(), column->begin() + module);
  auto& loadcell = signals_.loadcell;
  const auto gone = older(loadcell.t_s);
  const auto unmapped = static_cast<std::ptrdiff_t>(loadcell.t_s.size() - loadcell_s_.size());
  loadcell_s_.erase(loadcell_s_.begin(),
                    loadcell_s_.begin() + std::max<std::ptrdiff_t>(0, gone - unmapped));
  loadcell.t_s.erase(loadcell.t_s.begin(), loadcell.t_s.begin() + gone);
  loadcell.torque_nm.erase(loadcell.torque_nm.begin(), loadcell.torque_nm.begin() + gone);
  return static_cast<std::size_t>(module);
}

}  // namespace searig::app
