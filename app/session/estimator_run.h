// The estimator run over a recording, with the settings that a user chooses: what a view overlays.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/rig/history.h"
#include "app/session/regime_residuals.h"
#include "app/session/session.h"

namespace searig::app {

/// Where the torque of a run comes from.
enum class RunKind {
  online,  ///< the paper's estimator, one stiffness
  linear,  ///< the others of state_estimator.h, with the states that are asked for
  rls,
  moments,
  paper,
  simulation,  ///< no estimate at all: what the model says the load cell reads
};

/// "online", "linear" and so on, as the command line names them.
const char* name_of(RunKind kind);

struct RunSettings {
  RunKind kind = RunKind::online;
  std::vector<std::string> states = {"spring.linear"};   ///< of linear, rls, moments and paper
  std::optional<double> initial_k_nm_per_rad = {};       ///< else a good one
  std::optional<std::filesystem::path> model_file = {};  ///< else the recording's own model

  bool operator==(const RunSettings&) const = default;
};

/// "online from k = 400, extended.toml": what sets a run apart, for a legend.
std::string words_for(const RunSettings& settings);

struct EstimatorRun {
  RunSettings settings;
  History history;
  RegimeResiduals residuals;
  std::string remark;  ///< what could not be estimated, in sentences; else empty
};

/// Throws with one sentence where settings and recording do not go together.
EstimatorRun run_estimator(const Session& session, const RunSettings& settings);

/// The next columns of a run that is being estimated, without what was measured; none now and then.
/// What it throws stops the run and comes out of it.
using RunWatch = std::function<void(History more)>;

/// The same, watched. What the watch has been given is not in the run's history again.
EstimatorRun run_estimator(const Session& session, const RunSettings& settings,
                           const RunWatch& watch);

/// What a view shows at a time, seconds since the first telemetry; nothing outside the data.
struct RunValues {
  std::optional<double> measured_nm, estimated_nm, weight, stiffness_nm_per_rad;
};
RunValues values_at(const History& history, double t_s);

}  // namespace searig::app
