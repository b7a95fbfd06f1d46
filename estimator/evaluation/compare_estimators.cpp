#include "estimator/evaluation/compare_estimators.h"

#include <stdexcept>

#include "estimator/evaluation/state_track.h"
#include "estimator/model/predict.h"

namespace searig::estimator {

namespace {

constexpr const char* too_little = "too little has been seen for an interval";
constexpr const char* of_squares =
    "a squared error has no slope where the parameters are right, so the filter's P says nothing "
    "of its error";

EstimatorResult from_online(const OnlineResult& online) {
  EstimatorResult out{.kind = EstimatorKind::paper,
                      .score = online.score,
                      .parameters = {},
                      .why_no_interval = of_squares};
  out.parameters.push_back({"spring.linear", "k_nm_per_rad", online.k_nm_per_rad});
  return out;
}

EstimatorResult from_states(EstimatorKind kind, const Signals& signals,
                            const std::vector<double>& drive_nm, const SpringStates& states,
                            const StateOptions& options) {
  const ModuleSignals& module = signals.module;
  const StateTrack track = track_states(module, drive_nm, kind, states, options);
  const auto& at = signals.loadcell.t_s;
  EstimatorResult out{
      .kind = kind,
      .score = score(sample_at(module.t_s, track.torque_nm, at), signals.loadcell.torque_nm),
      .parameters = track.parameters,
      .why_no_interval = {}};
  const bool squares = kind == EstimatorKind::paper || kind == EstimatorKind::moments;
  if (!track.has_interval) out.why_no_interval = squares ? of_squares : too_little;
  return out;
}

}  // namespace

std::vector<EstimatorResult> compare_estimators(const Signals& signals, const Model* model,
                                                const std::vector<double>& drive_nm,
                                                const EvaluationOptions& options,
                                                const OnlineResult& online,
                                                std::vector<std::string>& notes) {
  const SpringStates states(options.states, model);
  const StateOptions state_options{.initial_k_nm_per_rad = online.initial_k_nm_per_rad};
  std::vector<EstimatorResult> out;
  for (const EstimatorKind kind : options.estimators) {
    try {
      out.push_back(kind == EstimatorKind::paper && states.size() == 1
                        ? from_online(online)
                        : from_states(kind, signals, drive_nm, states, state_options));
    } catch (const std::invalid_argument& why) {
      notes.push_back(std::string(name_of(kind)) + " is left out: " + why.what());
    }
  }
  return out;
}

}  // namespace searig::estimator
