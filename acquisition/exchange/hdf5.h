// An export as an HDF5 file.
#pragma once

#include <filesystem>

#include "acquisition/exchange/contents.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition::exchange {

/// A group for each of Contents' groups (names as identifiers() makes them): /module, /loadcell,
/// /device_NAME, /module_pings, /table; each column a dataset of doubles, contiguous and not
/// compressed, with the attributes "units" and "how". The root has the attributes "program",
/// "recording" and "clocks"; /facts is the JSON that import reads (facts.h), one string.
///
/// Throws std::runtime_error where the file cannot be written whole.
void write_hdf5(const Contents& contents, const std::string& program,
                const std::filesystem::path& file);

/// Throws InputError that begins with the file's name.
Recording read_hdf5(const std::filesystem::path& file);

}  // namespace searig::acquisition::exchange
