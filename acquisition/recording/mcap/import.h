// A recording from elsewhere as one MCAP file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "acquisition/recording/mcap/writer.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition::mcap {

/// Writes a recording whose rows are sorted and counted, so that it reads back as it is: the same
/// numbers, counts, restarts, further devices. `originals` are attached byte for byte. `program` is
/// "searig 0.1.0". Throws std::invalid_argument as write_recording() does.
void write_mcap(const Recording& recording, const std::vector<std::filesystem::path>& originals,
                const std::string& program, const Writer::Sink& sink);

/// A folder's files that such a recording was read from: recording.toml, model.toml, its CSV files.
std::vector<std::filesystem::path> originals_of(const Recording& recording);

}  // namespace searig::acquisition::mcap
