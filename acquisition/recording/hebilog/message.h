// The numbers in a protobuf message, without its schema (protobuf.dev, "Encoding").
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace searig::acquisition::hebilog {

/// Field numbers from the outermost message inwards, 12 bits each: 11.9.2 is 0x00b009002.
using Path = std::uint64_t;

constexpr Path operator""_path(const char* text, std::size_t size) {
  Path path = 0, number = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (text[i] != '.') number = 10 * number + Path(text[i] - '0');
    if (text[i] == '.' || i + 1 == size) path = path << 12 | number, number = 0;
  }
  return path;
}

/// "11.9.2"
std::string text_of(Path path);

/// What a message holds, in its order. Which fields are messages themselves protobuf does not say.
struct MessageHandler {
  std::function<bool(Path)> is_message;
  std::function<void(Path, std::uint64_t)> integer;
  std::function<void(Path, double)> real;
  std::function<void(Path, std::string_view)> bytes;
};

/// False where the bytes are no message.
bool read_message(std::string_view message, const MessageHandler& handler, Path outer = 0);

}  // namespace searig::acquisition::hebilog
