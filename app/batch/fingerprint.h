// What a recording's files are, without reading them through.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace searig::app {

struct Fingerprint {
  std::string text;         ///< name, size and time of change of each file, the model's too
  std::uint64_t bytes = 0;  ///< of all of them
};

/// Changes where one of the files that the recording is read from does, or model.toml beside them.
/// Of a recording that is not there or cannot be understood it tells what can be told; no throw.
Fingerprint fingerprint_of(const std::filesystem::path& recording);

}  // namespace searig::app
