#include "app/session/session.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "acquisition/clock/placed_rows.h"
#include "acquisition/error.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "acquisition/recording/text_file.h"
#include "app/session/device_channels.h"

namespace searig::app {
namespace {

using acquisition::at_rows;
using acquisition::PlacedRows;
using acquisition::Recording;
using acquisition::Stream;

/// take(name) gives a channel's values at t_s, or nothing.
template <class Take>
estimator::ModuleSignals module_signals(std::vector<double> t_s, Take take) {
  estimator::ModuleSignals signals;
  signals.t_s = std::move(t_s);
  for (const auto& [name, values] : estimator::module_channels) signals.*values = take(name);
  if (signals.deflection_rad.empty() && !signals.input_angle_rad.empty() &&
      !signals.output_angle_rad.empty()) {
    signals.deflection_rad.resize(signals.t_s.size());  // theta = q_i - q_o
    std::transform(signals.input_angle_rad.begin(), signals.input_angle_rad.end(),
                   signals.output_angle_rad.begin(), signals.deflection_rad.begin(),
                   std::minus<>());
  }
  return signals;
}

/// What the estimator refuses, with the recording's path before it.
template <class Evaluate>
estimator::Evaluation said_of(const Session& session, Evaluate evaluate) {
  try {
    return evaluate();
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(session.recording.path.string() + ": " + error.what() + ".");
  }
}

}  // namespace

estimator::ModuleSignals signals_of(const acquisition::Stream& module) {
  return module_signals(module.t_s, [&](std::string_view name) { return module.channel(name); });
}

estimator::LoadcellSignals loadcell_signals(const Recording& recording,
                                            const acquisition::ClockMap& clock) {
  const PlacedRows rows = acquisition::place_rows(recording.loadcell, clock.loadcell_runs);
  estimator::LoadcellSignals signals;
  signals.t_s = rows.t_s;
  signals.torque_nm = at_rows(recording.loadcell.channel("torque_nm"), rows);
  if (signals.torque_nm.empty()) {
    signals.torque_nm = at_rows(recording.loadcell.channel("force_n"), rows);
    for (double& torque : signals.torque_nm) torque *= recording.lever_arm_m;
  }
  return signals;
}

Session open_session(const std::filesystem::path& recording) {
  return session_of(acquisition::read_recording(recording));
}

Session session_of(acquisition::Recording recording) {
  Session session;
  session.recording = std::move(recording);
  if (session.recording.loadcell.t_s.empty())
    throw acquisition::InputError(session.recording.path.string() +
                                  ": holds a module's log and no load cell; there is nothing to "
                                  "hold the module against.");
  session.clock = acquisition::synchronise(session.recording);
  const Stream& module = session.recording.module;
  for (const acquisition::Device& device : session.recording.devices)
    session.devices.push_back(acquisition::synchronise(session.recording, device));
  session.module_rows = covered_rows(session.recording, session.devices,
                                     acquisition::place_rows(module, session.clock.module_runs));
  if (session.module_rows.rows.empty())
    throw acquisition::InputError(session.recording.path.string() +
                                  ": the further devices cover no row of the module.");
  const auto supplied = device_channels(session.recording, session.devices, session.module_rows);
  session.signals.module = module_signals(session.module_rows.t_s, [&](std::string_view name) {
    const auto by_device = std::ranges::find(supplied, name, &acquisition::Channel::name);
    return by_device != supplied.end() ? by_device->values
                                       : at_rows(module.channel(name), session.module_rows);
  });
  session.signals.loadcell = loadcell_signals(session.recording, session.clock);
  session.signals.clock_ci95_s = session.clock.ci95_s;
  session.signals.gear_ratio = session.recording.gear_ratio;
  return session;
}

estimator::Evaluation evaluate_session(const Session& session,
                                       const std::optional<estimator::Model>& model,
                                       const estimator::EvaluationOptions& options) {
  return said_of(session, [&] {
    return estimator::evaluate(session.signals, model ? &*model : nullptr, options);
  });
}

estimator::Evaluation evaluate_session(const Session& session,
                                       const std::optional<estimator::Model>& model,
                                       const estimator::EvaluationOptions& options,
                                       const estimator::Watch& watch) {
  return said_of(session, [&] {
    return estimator::evaluate(session.signals, model ? &*model : nullptr, options, watch);
  });
}

double start_of(const Session& session) {
  const auto& t_s = session.signals.module.t_s;
  return t_s.empty() ? 0.0 : t_s.front();
}

std::optional<estimator::Model> find_model(const std::filesystem::path& recording,
                                           const std::optional<std::filesystem::path>& model_file) {
  const auto read = [](const std::filesystem::path& file) {
    return estimator::parse_model(acquisition::read_text_file(file), file.string());
  };
  if (model_file) return read(*model_file);
  if (acquisition::mcap::is_mcap(recording)) {
    const std::string toml = acquisition::mcap::read_settings(recording).model_toml;
    if (toml.empty()) return std::nullopt;
    return estimator::parse_model(toml, recording.string() + ", its model");
  }
  const std::filesystem::path folder =
      std::filesystem::is_directory(recording) ? recording : recording.parent_path();
  if (std::filesystem::exists(folder / "model.toml")) return read(folder / "model.toml");
  return std::nullopt;
}

std::optional<estimator::Model> find_model(const Recording& recording,
                                           const std::optional<std::filesystem::path>& model_file) {
  if (model_file || !acquisition::mcap::is_mcap(recording.path))
    return find_model(recording.path, model_file);
  if (recording.model_toml.empty()) return std::nullopt;
  return estimator::parse_model(recording.model_toml, recording.path.string() + ", its model");
}

}  // namespace searig::app
