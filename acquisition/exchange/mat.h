// An export as a MATLAB file.
#pragma once

#include <filesystem>

#include "acquisition/exchange/contents.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition::exchange {

/// Version 5 of MathWorks' "MAT-File Format", not compressed. A struct for each of Contents' groups
/// (names as identifiers() makes them): module, loadcell, device_NAME, module_pings, table; each
/// column a double of rows x 1. Beside them
///
///     units.GROUP.COLUMN   text
///     how.GROUP.COLUMN     text: how the values came to be
///     provenance           program, recording, clocks, and facts (facts.h), which import reads
///
/// Throws std::runtime_error where the file cannot be written whole, and InputError where a group
/// has 2 GB or more, which no variable of such a file can hold.
void write_mat(const Contents& contents, const std::string& program,
               const std::filesystem::path& file);

/// Throws InputError that begins with the file's name.
Recording read_mat(const std::filesystem::path& file);

}  // namespace searig::acquisition::exchange
