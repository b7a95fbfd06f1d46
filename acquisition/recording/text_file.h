// A whole file as one string.
#pragma once

#include <filesystem>
#include <string>

namespace searig::acquisition {

/// Reads the file in one go. Throws InputError where it is not there, is no file or may not be
/// read.
std::string read_text_file(const std::filesystem::path& path);

}  // namespace searig::acquisition
