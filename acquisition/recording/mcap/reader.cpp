#include "acquisition/recording/mcap/reader.h"

#include "acquisition/recording/mcap/chunk.h"

namespace searig::acquisition::mcap {
namespace {

constexpr std::uint64_t record_head = 1 + 8;  // opcode and length
constexpr std::uint64_t footer_size = record_head + 8 + 8 + 4;

bool is_header(std::string_view content) {
  ByteReader reader(content);
  reader.take_sized<std::uint32_t>();
  reader.take_sized<std::uint32_t>();
  return !reader.ran_out() && reader.empty();
}

/// Its entries are not used here, and the CRC of all data, at their end, covers them; but a chunk
/// whose opcode was damaged must not pass for one.
bool is_message_index(std::string_view content, const Channels& known) {
  ByteReader reader(content);
  const auto channel = reader.take<std::uint16_t>();
  const std::string_view entries = reader.take_sized<std::uint32_t>();
  return !reader.ran_out() && reader.empty() && entries.size() % 16 == 0 &&
         known.channels.contains(channel);
}

/// What follows the data: index, footer, magic. `at` is where the DataEnd record begins.
Ending read_end(std::string_view bytes, std::uint64_t at, std::string_view data_end) {
  const auto data_crc = ByteReader(data_end).take<std::uint32_t>();
  if (data_crc != 0 && data_crc != crc32_of(bytes.substr(0, at)))
    return {End::index, at, "is damaged between its chunks"};
  std::string_view rest = bytes.substr(at + record_head + data_end.size());
  if (rest.size() < footer_size + magic.size() || !rest.ends_with(magic))
    return {End::index, at, "ends within its index"};
  rest.remove_suffix(magic.size());
  const std::size_t crc_at = rest.size() - sizeof(std::uint32_t);
  const auto crc = ByteReader(rest.substr(crc_at)).take<std::uint32_t>();
  if (crc != 0 && crc != crc32_of(rest.substr(0, crc_at)))
    return {End::index, at, "has a damaged index"};
  return {End::whole, bytes.size(), {}};
}

Ending unfit(std::string_view bytes) {
  if (magic.starts_with(bytes)) return {End::cut, 0, "ends within its first bytes"};
  return {End::unfit, 0, "is no MCAP file"};
}

}  // namespace

Ending read(std::string_view bytes, Handler& handler) {
  if (!bytes.starts_with(magic)) return unfit(bytes);
  Channels known;
  for (std::uint64_t at = magic.size();;) {
    ByteReader reader(bytes.substr(at));
    if (reader.empty()) return {End::cut, at, "was not finished"};
    const auto opcode = static_cast<Opcode>(reader.take<std::uint8_t>());
    const std::string_view content = reader.take_sized<std::uint64_t>();
    if (reader.ran_out()) return {End::cut, at, "ends within a record"};

    const bool first = at == magic.size();
    if (first != (opcode == Opcode::header) || (first && !is_header(content)))
      return {End::damaged, at, "has a damaged header"};
    switch (opcode) {
      case Opcode::header:
      case Opcode::metadata:
        break;
      case Opcode::message_index:
        if (!is_message_index(content, known)) return {End::damaged, at, "has a damaged record"};
        break;
      case Opcode::chunk:
        if (std::string why = read_chunk(content, known, handler); !why.empty())
          return {End::damaged, at, "is damaged: " + why};
        break;
      case Opcode::attachment: {
        const Parsed<Attachment> parsed = parse_attachment(content);
        if (!parsed.fits) return {End::damaged, at, "has a damaged attachment"};
        handler.attachment(parsed.record);
        break;
      }
      case Opcode::data_end:
        if (content.size() != sizeof(std::uint32_t))
          return {End::damaged, at, "has a damaged record"};
        return read_end(bytes, at, content);
      default:
        return {End::damaged, at, "has a damaged record"};
    }
    at += record_head + content.size();
  }
}

}  // namespace searig::acquisition::mcap
