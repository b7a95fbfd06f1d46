// A recording out of an MCAP file.
#pragma once

#include <filesystem>
#include <string_view>

#include "acquisition/recording/mcap/reader.h"
#include "acquisition/recording/mcap/settings.h"
#include "acquisition/recording/module_rows.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition::mcap {

/// Whether a path is to be read as MCAP: by its ending, or by the file's first bytes.
bool is_mcap(const std::filesystem::path& path);

/// What a file holds up to the first damage, which recording.cut_off tells of. Throws InputError
/// where that is not enough to be a recording.
Recording read_mcap(const std::filesystem::path& path);

/// The same without the module's channels, see open_recording(). Nothing where it has further
/// devices.
std::optional<OpenedRecording> open_mcap(const std::filesystem::path& path);

/// The same of bytes that are in memory; `name` is what sentences call them.
Recording recording_of(std::string_view bytes, const std::string& name);

/// The settings alone, with the model in them.
Settings read_settings(const std::filesystem::path& path);

/// "The file ends within a record; 120 bytes behind what is whole are left out.", or empty.
std::string cut_off(const Ending& ending, std::size_t size);

}  // namespace searig::acquisition::mcap
