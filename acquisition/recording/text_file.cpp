#include "acquisition/recording/text_file.h"

#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <memory>
#include <stdexcept>

#include "acquisition/error.h"

namespace searig::acquisition {

std::string read_text_file(const std::filesystem::path& path) {
  const auto refuse = [&](int error) {
    throw InputError(path.string() + ": cannot be read: " + std::strerror(error) + ".");
  };
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                       &std::fclose);
  if (!file) refuse(errno);

  std::string text;
  std::error_code unknown_size;  // a pipe has none; it is read all the same
  const auto size = std::filesystem::file_size(path, unknown_size);
  std::size_t room = unknown_size ? 0 : static_cast<std::size_t>(size);
  room += 1;  // one byte more than the file has shows its end in a single read
  std::size_t filled = 0;
  while (true) {
    text.resize(filled + room);
    const std::size_t got = std::fread(text.data() + filled, 1, room, file.get());
    filled += got;
    if (got < room) break;
    room = text.size();
  }
  if (std::ferror(file.get())) refuse(errno);
  text.resize(filled);
  return text;
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
  std::FILE* file = std::fopen(path.c_str(), "wb");
  bool done = file && std::fwrite(text.data(), 1, text.size(), file) == text.size();
  int error = errno;
  if (file && std::fclose(file) != 0) {  // a full disk may show only here
    done = false;
    error = errno;
  }
  if (!done)
    throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(error) + ".");
}

void append_number(std::string& text, double number) {
  char digits[32];
  const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
  text.append(digits, end);
}

}  // namespace searig::acquisition
