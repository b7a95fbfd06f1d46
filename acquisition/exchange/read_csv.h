// The long form of an export (csv.h) read back.
#pragma once

#include <filesystem>

#include "acquisition/recording/recording.h"

namespace searig::acquisition::exchange {

/// Rows must be as they were written: a sample's together, in the order that the facts tell.
/// Throws InputError with file and line.
Recording read_csv_long(const std::filesystem::path& file);

}  // namespace searig::acquisition::exchange
