// A recording out of whatever searig reads.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "acquisition/recording/recording.h"

namespace searig::acquisition::exchange {

enum class Kind { recording, csv_long, mat, hdf5, hebilog };

/// What a path is, by its first bytes: an export, a HEBI log, else a recording (a folder, its
/// recording.toml, an .mcap file).
Kind kind_of(const std::filesystem::path& path);

/// Reads it; an export comes back as the recording that was exported. `hebi_module`: which of
/// several in a HEBI log, from 1. Throws InputError.
Recording read_any(const std::filesystem::path& path,
                   std::optional<std::size_t> hebi_module = std::nullopt);

}  // namespace searig::acquisition::exchange
