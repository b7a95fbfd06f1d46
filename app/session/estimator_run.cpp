#include "app/session/estimator_run.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "app/report/quantity.h"
#include "app/session/hand_over.h"
#include "estimator/evaluation/state_track.h"
#include "estimator/model/predict.h"

namespace searig::app {
namespace {

using estimator::EstimatorKind;

std::string remarks(const std::vector<std::string>& notes) {
  std::string out;
  for (const auto& note : notes) out += capital(note) + ". ";
  return out;
}

std::runtime_error about(const Session& session, const std::string& words) {
  return std::runtime_error(session.recording.path.string() + ": " + words + ".");
}

EstimatorKind kind_of(RunKind kind) {
  switch (kind) {
    case RunKind::rls:
      return EstimatorKind::rls;
    case RunKind::moments:
      return EstimatorKind::moments;
    case RunKind::paper:
      return EstimatorKind::paper;
    default:
      return EstimatorKind::linear;
  }
}

std::vector<double> since_start(const estimator::ModuleSignals& module) {
  std::vector<double> t_s(module.t_s);
  for (double& t : t_s) t -= module.t_s.front();
  return t_s;
}

/// Of several states: the torque of them all, and the stiffness among them, less what softening has
/// taken of it. Drive and trust weight are the online estimate's.
void replace_by_states(EstimatorRun& run, const Session& session, const estimator::Model* model,
                       double initial_k) {
  const auto& module = session.signals.module;
  const estimator::SpringStates states(run.settings.states, model);
  History& history = run.history;
  std::vector<double> t_s = since_start(module);
  history.current_nm = estimator::sample_at(history.t_s, history.current_nm, t_s);
  history.weight = estimator::sample_at(history.t_s, history.weight, t_s);
  history.t_s = std::move(t_s);
  auto track = estimator::track_states(module, history.current_nm, kind_of(run.settings.kind),
                                       states, {.initial_k_nm_per_rad = initial_k});
  history.estimated_nm = std::move(track.torque_nm);
  Eigen::VectorXd k = track.x.col(states.stiffness());
  if (states.softening()) k -= track.x.col(*states.softening());
  history.stiffness_nm_per_rad.assign(k.begin(), k.end());
  history.stiffness_sd_nm_per_rad.clear();
}

RegimeResiduals residuals_of(const Session& session, const History& history) {
  ResidualFinder finder(session.signals);
  const double start_s = start_of(session);
  for (std::size_t i = 0; i < history.estimated_nm.size(); ++i)
    finder.push(start_s + history.t_s[i], history.estimated_nm[i]);
  return finder.finish();
}

EstimatorRun simulation_of(const Session& session, const RunSettings& settings,
                           const std::optional<estimator::Model>& model) {
  if (!model) throw about(session, "has no model to simulate; choose a model file");
  auto torques = estimator::predict(*model, session.signals.module);
  if (torques.loadcell_nm.empty())
    throw about(session, "lacks the channels that the model's spring needs");
  EstimatorRun run{settings, {}, {}, {}};
  run.history.set_measured(session.signals.loadcell, start_of(session));
  run.history.t_s = since_start(session.signals.module);
  run.history.estimated_nm = std::move(torques.loadcell_nm);
  run.history.current_nm = std::move(torques.drive_nm);
  run.residuals = residuals_of(session, run.history);
  return run;
}

std::optional<double> value_at(const std::vector<double>& t_s, const std::vector<double>& values,
                               double at_s) {
  if (values.empty() || values.size() != t_s.size() || at_s < t_s.front() || at_s > t_s.back())
    return std::nullopt;
  const auto after = std::ranges::lower_bound(t_s, at_s);
  const std::size_t i = std::max<std::ptrdiff_t>(1, after - t_s.begin());
  if (t_s.size() == 1) return values.front();
  const double share = (at_s - t_s[i - 1]) / (t_s[i] - t_s[i - 1]);
  return values[i - 1] + share * (values[i] - values[i - 1]);
}

}  // namespace

const char* name_of(RunKind kind) {
  constexpr const char* names[] = {"online", "linear", "rls", "moments", "paper", "simulation"};
  return names[static_cast<int>(kind)];
}

std::string words_for(const RunSettings& settings) {
  std::string out = name_of(settings.kind);
  const bool several = settings.kind != RunKind::online && settings.kind != RunKind::simulation;
  if (several && settings.states.size() > 1) {
    out += " with ";
    for (std::size_t i = 1; i < settings.states.size(); ++i)
      out += (i > 1 ? ", " : "") + settings.states[i];
  }
  if (settings.initial_k_nm_per_rad && settings.kind != RunKind::simulation)
    out += " from k = " + figures(*settings.initial_k_nm_per_rad);
  if (settings.model_file) out += ", " + settings.model_file->filename().string();
  return out;
}

EstimatorRun run_estimator(const Session& session, const RunSettings& settings) {
  return run_estimator(session, settings, {});
}

EstimatorRun run_estimator(const Session& session, const RunSettings& settings,
                           const RunWatch& watch) {
  const auto model = find_model(session.recording, settings.model_file);
  if (settings.kind == RunKind::simulation) {
    EstimatorRun run = simulation_of(session, settings, model);
    run.history.estimated_from = words_for(settings);
    return run;
  }
  EstimatorRun run{settings, {}, {}, {}};
  const double start_s = start_of(session);
  const bool gives = watch && settings.kind == RunKind::online;
  ResidualFinder residuals(session.signals);
  const auto evaluation = evaluate_session(
      session, model, {.initial_k_nm_per_rad = settings.initial_k_nm_per_rad},
      {.track =
           [&](auto track) {
             History more;
             for (const auto& estimate : track) {
               (gives ? more : run.history).append(estimate, start_s);
               residuals.push(estimate.t_s, estimate.torque_nm);
             }
             if (watch) watch(std::move(more));
           },
       .pass = make_ahead<estimator::DrivenRows, estimator::Watch::Make, estimator::Watch::Give>});
  run.remark = remarks(evaluation.notes);
  if (evaluation.online) {
    run.history.set_measured(session.signals.loadcell, start_s);
    run.residuals = residuals.finish();
  } else {
    run.history = history_of(session.signals, evaluation);
    run.residuals = residuals_of(session, run.history);
  }
  if (settings.kind == RunKind::online) return run;
  if (!evaluation.online) throw about(session, "has no online estimate, so none of several states");
  try {
    replace_by_states(run, session, model ? &*model : nullptr,
                      evaluation.online->initial_k_nm_per_rad);
  } catch (const std::invalid_argument& error) {
    throw about(session, error.what());
  }
  run.residuals = residuals_of(session, run.history);
  run.history.estimated_from = words_for(settings);
  return run;
}

RunValues values_at(const History& history, double t_s) {
  return {value_at(history.measured_t_s, history.measured_nm, t_s),
          value_at(history.t_s, history.estimated_nm, t_s),
          value_at(history.t_s, history.weight, t_s),
          value_at(history.t_s, history.stiffness_nm_per_rad, t_s)};
}

}  // namespace searig::app
