// Where the model that a diagnosis extended is kept: beside its recording.
#pragma once

#include <filesystem>

#include "estimator/model/model.h"

namespace searig::app {

/// Writes RECORDING.extended.toml beside a file, extended.toml into a folder, with a number where
/// that is there already: nothing is replaced, and a folder's own model.toml stays. Returns where.
/// Throws std::runtime_error with one sentence where it cannot be written.
std::filesystem::path keep_extended_model(const std::filesystem::path& recording,
                                          const estimator::Model& model);

}  // namespace searig::app
