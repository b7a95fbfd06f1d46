// Opens a recording and brings both streams to the module's clock: acquisition meets estimator.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "acquisition/clock/placed_rows.h"
#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/recording.h"
#include "estimator/evaluation/evaluation.h"
#include "estimator/model/model.h"
#include "estimator/signals.h"

namespace searig::app {

struct Session {
  acquisition::Recording recording;
  acquisition::ClockMap clock;                 ///< the load cell's
  std::vector<acquisition::ClockMap> devices;  ///< of recording.devices, in their order
  acquisition::PlacedRows module_rows;         ///< the rows of the module that signals hold
  estimator::Signals signals;
};

/// Reads and synchronises. Where a further device supplies a channel, it is brought to the module's
/// rows along straight lines between its own; rows of the module that it does not cover are left
/// out of the signals. Throws acquisition::InputError.
Session open_session(const std::filesystem::path& recording);

/// The same for a recording that is already in memory.
Session session_of(acquisition::Recording recording);

/// Rows that all stand on the module's clock already, in its order.
estimator::ModuleSignals signals_of(const acquisition::Stream& module);

/// The load cell on the module's clock.
estimator::LoadcellSignals loadcell_signals(const acquisition::Recording& recording,
                                            const acquisition::ClockMap& clock);

/// Best fit, online and current. The estimator knows no file: what it refuses is said of the
/// recording, by its path.
estimator::Evaluation evaluate_session(const Session& session,
                                       const std::optional<estimator::Model>& model,
                                       const estimator::EvaluationOptions& options = {});
/// The same while it is watched.
estimator::Evaluation evaluate_session(const Session& session,
                                       const std::optional<estimator::Model>& model,
                                       const estimator::EvaluationOptions& options,
                                       const estimator::Watch& watch);

/// On the module's clock; 0 where it has no samples.
double start_of(const Session& session);

/// The model to hold against a recording: `model_file` where given, else model.toml in the
/// recording, else none. Throws with one sentence where the file cannot be used.
std::optional<estimator::Model> find_model(const std::filesystem::path& recording,
                                           const std::optional<std::filesystem::path>& model_file);

/// The same of a recording that has been read, whose file is not read again for it.
std::optional<estimator::Model> find_model(const acquisition::Recording& recording,
                                           const std::optional<std::filesystem::path>& model_file);

}  // namespace searig::app
