// A whole file as one string, and numbers into text without losing a digit.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace searig::acquisition {

/// Reads the file in one go. Throws InputError where it is not there, is no file or may not be
/// read.
std::string read_text_file(const std::filesystem::path& path);

/// Writes the file in one go. Throws std::runtime_error with one sentence where that fails.
void write_text_file(const std::filesystem::path& path, std::string_view text);

/// Appends the shortest decimal that reads back as exactly this number.
void append_number(std::string& text, double number);

}  // namespace searig::acquisition
