#include "acquisition/recording/hebilog/message.h"

#include <bit>
#include <optional>

namespace searig::acquisition::hebilog {
namespace {

constexpr Path largest_number = 0xfff;         // that a path can hold
constexpr Path deepest = Path{1} << (4 * 12);  // five numbers and no more

/// Takes bytes from the front of a message; nothing where it is too short.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}
  bool empty() const { return bytes_.empty(); }

  std::optional<std::uint64_t> varint() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64 && !bytes_.empty(); shift += 7) {
      const auto byte = static_cast<unsigned char>(bytes_.front());
      bytes_.remove_prefix(1);
      value |= std::uint64_t(byte & 0x7f) << shift;
      if (byte < 0x80) return value;
    }
    return std::nullopt;
  }

  std::optional<std::string_view> take(std::uint64_t size) {
    if (size > bytes_.size()) return std::nullopt;
    const std::string_view taken = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return taken;
  }

  template <typename Unsigned>
  std::optional<Unsigned> little_endian() {
    const auto bytes = take(sizeof(Unsigned));
    if (!bytes) return std::nullopt;
    Unsigned value = 0;
    for (std::size_t i = sizeof(Unsigned); i-- > 0;)
      value = value << 8 | static_cast<unsigned char>((*bytes)[i]);
    return value;
  }

 private:
  std::string_view bytes_;
};

bool read_bytes(Bytes& bytes, const MessageHandler& handler, Path path) {
  const auto size = bytes.varint();
  const auto taken = size ? bytes.take(*size) : std::nullopt;
  if (!taken) return false;
  if (path < deepest && handler.is_message(path)) return read_message(*taken, handler, path);
  handler.bytes(path, *taken);
  return true;
}

bool read_field(Bytes& bytes, const MessageHandler& handler, Path outer) {
  const auto key = bytes.varint();
  if (!key || *key >> 3 == 0 || *key >> 3 > largest_number) return false;
  const Path path = outer << 12 | *key >> 3;
  switch (*key & 7) {
    case 0:
      if (const auto value = bytes.varint()) return handler.integer(path, *value), true;
      return false;
    case 1:
      if (const auto value = bytes.little_endian<std::uint64_t>())
        return handler.real(path, std::bit_cast<double>(*value)), true;
      return false;
    case 2:
      return read_bytes(bytes, handler, path);
    case 5:
      if (const auto value = bytes.little_endian<std::uint32_t>())
        return handler.real(path, std::bit_cast<float>(*value)), true;
      return false;
    default:
      return false;
  }
}

}  // namespace

std::string text_of(Path path) {
  std::string text;
  for (int level = 4; level >= 0; --level)
    if (const Path number = path >> (12 * level) & largest_number; number != 0)
      text.append(text.empty() ? "" : ".").append(std::to_string(number));
  return text;
}

bool read_message(std::string_view message, const MessageHandler& handler, Path outer) {
  Bytes bytes(message);
  while (!bytes.empty())
    if (!read_field(bytes, handler, outer)) return false;
  return true;
}

}  // namespace searig::acquisition::hebilog
