#include "acquisition/recording/hebilog/frames.h"

#include <optional>

namespace searig::acquisition::hebilog {
namespace {

constexpr std::size_t data_head = 24;  // of types 1 and 5, before n is counted

std::uint64_t big_endian(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
  return value;
}

struct Sized {
  Frame frame;
  std::size_t size = 0;
};

std::optional<Sized> data_frame(std::string_view rest, Frame::Type type) {
  if (rest.size() < data_head + 2) return std::nullopt;
  const std::uint64_t n = big_endian(rest, 12, 4);
  if (n < 2 || n > rest.size() - data_head || big_endian(rest, data_head, 2) != n - 2)
    return std::nullopt;
  return Sized{
      {type, big_endian(rest, 4, 8), big_endian(rest, 16, 8), rest.substr(data_head + 2, n - 2)},
      data_head + n};
}

/// The frame that begins here, if all of it is here and the next begins behind it.
std::optional<Sized> frame_at(std::string_view file, std::size_t at) {
  const std::string_view rest = file.substr(at);
  if (rest.size() < 8 || !rest.starts_with(magic)) return std::nullopt;
  const auto type = static_cast<Frame::Type>(big_endian(rest, 2, 2));
  std::optional<Sized> found;
  if (type == Frame::Type::feedback || type == Frame::Type::information)
    found = data_frame(rest, type);
  else if (type == Frame::Type::header)
    found = Sized{{type, 0, 0, {}}, 8 + 8 * std::size_t(big_endian(rest, 4, 4))};
  else if (type == Frame::Type::format)
    found = Sized{{type, 0, 0, {}}, 12};
  if (!found || found->size > rest.size()) return std::nullopt;
  const std::string_view behind = rest.substr(found->size);
  return behind.empty() || behind.starts_with(magic.substr(0, behind.size())) ? found
                                                                              : std::nullopt;
}

}  // namespace

Damage read_frames(std::string_view file, const std::function<bool(const Frame&)>& take) {
  Damage damage;
  std::size_t damaged_from = file.npos;  // npos: the last frame was whole
  const auto add = [&](std::size_t from, std::size_t to) {
    if (damage.places++ == 0) damage.first_at = from;
    damage.bytes += to - from;
  };
  std::size_t at = 0;
  while (at < file.size()) {
    const auto frame = frame_at(file, at);
    if (!frame) {
      if (damaged_from == file.npos) damaged_from = at;
      at = std::min(file.find(magic, at + 1), file.size());
      continue;
    }
    if (damaged_from != file.npos) add(damaged_from, at);
    damaged_from = file.npos;
    const std::size_t end = at + frame->size;
    if (!take(frame->frame)) add(at, end);
    at = end;
  }
  if (damaged_from != file.npos) {
    add(damaged_from, file.size());
    damage.at_end = true;
  }
  return damage;
}

}  // namespace searig::acquisition::hebilog
