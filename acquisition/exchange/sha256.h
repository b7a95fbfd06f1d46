// The SHA-256 of a file, as sha256sum prints it.
#pragma once

#include <filesystem>
#include <string>

namespace searig::acquisition::exchange {

/// Throws InputError where the file cannot be read.
std::string sha256_of(const std::filesystem::path& file);

}  // namespace searig::acquisition::exchange
