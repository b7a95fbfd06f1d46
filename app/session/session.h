// Opens a recording and brings both streams to the module's clock: acquisition meets estimator.
#pragma once

#include <filesystem>
#include <optional>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/recording.h"
#include "estimator/model/model.h"
#include "estimator/signals.h"

namespace searig::app {

struct Session {
  acquisition::Recording recording;
  acquisition::ClockMap clock;
  estimator::Signals signals;
};

/// Reads and synchronises. Throws acquisition::InputError.
Session open_session(const std::filesystem::path& recording);

/// The same for a recording that is already in memory.
Session session_of(acquisition::Recording recording);

/// The model to hold against a recording: `model_file` where given, else model.toml in the
/// recording, else none. Throws with one sentence where the file cannot be used.
std::optional<estimator::Model> find_model(const std::filesystem::path& recording,
                                           const std::optional<std::filesystem::path>& model_file);

}  // namespace searig::app
