#include "app/session/session.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include "acquisition/error.h"
#include "acquisition/recording/text_file.h"

namespace searig::app {
namespace {

using acquisition::Recording;
using acquisition::Stream;

/// The rows of a stream that have a place on the module's clock, in its order, each time once.
struct Placed {
  std::vector<std::size_t> rows;
  std::vector<double> t_s;
};

Placed placed(const Stream& stream, const std::vector<acquisition::RunMap>& runs) {
  const std::vector<double> t_s = acquisition::on_module_clock(stream, runs);
  std::vector<std::size_t> order(t_s.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t row) { return std::isnan(t_s[row]); });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return t_s[a] < t_s[b]; });
  Placed result;
  for (const std::size_t row : order) {
    if (!result.t_s.empty() && t_s[row] == result.t_s.back()) continue;
    result.rows.push_back(row);
    result.t_s.push_back(t_s[row]);
  }
  return result;
}

/// A channel at those rows; empty where the stream has none.
std::vector<double> at(const Stream& stream, std::string_view channel,
                       const std::vector<std::size_t>& rows) {
  const std::vector<double>& values = stream.channel(channel);
  std::vector<double> result;
  if (values.empty()) return result;
  result.reserve(rows.size());
  for (const std::size_t row : rows) result.push_back(values[row]);
  return result;
}

estimator::ModuleSignals module_signals(const Stream& module, const Placed& at_rows) {
  const auto take = [&](std::string_view channel) { return at(module, channel, at_rows.rows); };
  estimator::ModuleSignals signals;
  signals.t_s = at_rows.t_s;
  signals.input_angle_rad = take("input_angle_rad");
  signals.output_angle_rad = take("output_angle_rad");
  signals.deflection_rad = take("deflection_rad");
  signals.input_velocity_rad_s = take("input_velocity_rad_s");
  signals.current_a = take("current_a");
  signals.motor_angle_rad = take("motor_angle_rad");
  signals.commanded_angle_rad = take("commanded_angle_rad");
  signals.winding_temperature_c = take("winding_temperature_c");
  signals.spring_temperature_c = take("spring_temperature_c");
  if (signals.deflection_rad.empty() && !signals.input_angle_rad.empty() &&
      !signals.output_angle_rad.empty()) {
    signals.deflection_rad.resize(signals.t_s.size());  // theta = q_i - q_o
    std::transform(signals.input_angle_rad.begin(), signals.input_angle_rad.end(),
                   signals.output_angle_rad.begin(), signals.deflection_rad.begin(),
                   std::minus<>());
  }
  return signals;
}

estimator::LoadcellSignals loadcell_signals(const Recording& recording, const Placed& at_rows) {
  estimator::LoadcellSignals signals;
  signals.t_s = at_rows.t_s;
  signals.torque_nm = at(recording.loadcell, "torque_nm", at_rows.rows);
  if (signals.torque_nm.empty()) {
    signals.torque_nm = at(recording.loadcell, "force_n", at_rows.rows);
    for (double& torque : signals.torque_nm) torque *= recording.lever_arm_m;
  }
  return signals;
}

}  // namespace

Session open_session(const std::filesystem::path& recording) {
  Session session;
  session.recording = acquisition::read_recording(recording);
  session.clock = acquisition::synchronise(session.recording);
  session.signals.module = module_signals(
      session.recording.module, placed(session.recording.module, session.clock.module_runs));
  session.signals.loadcell = loadcell_signals(
      session.recording, placed(session.recording.loadcell, session.clock.loadcell_runs));
  session.signals.clock_ci95_s = session.clock.ci95_s;
  session.signals.gear_ratio = session.recording.gear_ratio;
  return session;
}

std::optional<estimator::Model> find_model(const std::filesystem::path& recording,
                                           const std::optional<std::filesystem::path>& model_file) {
  const auto read = [](const std::filesystem::path& file) {
    return estimator::parse_model(acquisition::read_text_file(file), file.string());
  };
  if (model_file) return read(*model_file);
  const std::filesystem::path folder =
      std::filesystem::is_directory(recording) ? recording : recording.parent_path();
  if (std::filesystem::exists(folder / "model.toml")) return read(folder / "model.toml");
  return std::nullopt;
}

}  // namespace searig::app
