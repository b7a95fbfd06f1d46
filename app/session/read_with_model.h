// A recording with the model that lies beside it.
#pragma once

#include <filesystem>

#include "acquisition/recording/recording.h"

namespace searig::app {

/// As read_recording(); a folder's model.toml, where there is one, goes into recording.model_toml,
/// as one file has it. Throws with one sentence where the model cannot be used.
acquisition::Recording read_with_model(const std::filesystem::path& path);

}  // namespace searig::app
