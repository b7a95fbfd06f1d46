// A filter of several states run over a recording, sample by sample.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "estimator/filter/state_estimator.h"
#include "estimator/signals.h"

namespace searig::estimator {

/// Shapes: torque_nm is as long as the telemetry; x has a row per sample and a column per state.
/// Row i has seen nothing later than the smoothing window about sample i.
struct StateTrack {
  std::vector<double> torque_nm;  ///< phi'x, the estimate of the output torque
  Eigen::MatrixXd x;
  std::vector<StateParameter> parameters;  ///< at the end
  bool has_interval = false;               ///< whether the parameters' sd and dof mean something
};

/// drive_nm is T_current at every sample of the telemetry. Throws std::invalid_argument with one
/// sentence where the telemetry lacks what a state needs.
StateTrack track_states(const ModuleSignals& module, const std::vector<double>& drive_nm,
                        EstimatorKind kind, const SpringStates& states,
                        const StateOptions& options);

}  // namespace searig::estimator
