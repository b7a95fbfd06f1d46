// A recording as a native folder.
#pragma once

#include <filesystem>

#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// Writes recording.toml, module.csv and loadcell.csv; the folder is made where it is not there.
/// Every number reads back exactly as it is. Counts are not written: reading makes them anew. Two
/// streams on one clock are written without the load cell's host stamps, so that they stay on one.
/// Throws std::invalid_argument where a value is not finite or a channel is not of the stream's
/// size, std::runtime_error where a file cannot be written.
void write_recording(const Recording& recording, const std::filesystem::path& folder);

}  // namespace searig::acquisition
