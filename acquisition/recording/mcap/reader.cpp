#include "acquisition/recording/mcap/reader.h"

#include <algorithm>

#include "acquisition/recording/mcap/chunk.h"

namespace searig::acquisition::mcap {
namespace {

constexpr std::uint64_t record_head = 1 + 8;       // opcode and length
constexpr std::uint64_t longest_search = 1 << 16;  // bytes, for the first chunk
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

struct Record {
  Opcode opcode{};
  std::string_view content;
  bool fits = false;  ///< into the file
};

Record record_at(std::string_view bytes, std::uint64_t at) {
  ByteReader reader(bytes.substr(at));
  const auto opcode = static_cast<Opcode>(reader.take<std::uint8_t>());
  const std::string_view content = reader.take_sized<std::uint64_t>();
  return {opcode, content, !reader.ran_out()};
}

/// Where the records behind the header begin, or 0 where the header is not as it must be.
std::uint64_t behind_header(std::string_view bytes) {
  if (!bytes.starts_with(magic)) return 0;
  const Record header = record_at(bytes, magic.size());
  const bool good = header.fits && header.opcode == Opcode::header && is_header(header.content);
  return good ? magic.size() + record_head + header.content.size() : 0;
}

/// Hands on the first chunk that is one, by its own CRC, and returns where it ends; 0 where there
/// is none. Its channels are known from nowhere else, so it is the file's first.
std::uint64_t find_first_chunk(std::string_view bytes, Channels& known, Handler& handler) {
  for (std::uint64_t at = 0; at < std::min<std::uint64_t>(bytes.size(), longest_search); ++at) {
    if (static_cast<Opcode>(bytes[at]) != Opcode::chunk) continue;
    const Record record = record_at(bytes, at);
    if (record.fits && read_chunk(record.content, known, handler).empty())
      return at + record_head + record.content.size();
  }
  return 0;
}

Ending unfit(std::string_view bytes) {
  if (magic.starts_with(bytes)) return {End::cut, 0, "ends within its first bytes"};
  if (!bytes.starts_with(magic)) return {End::unfit, 0, "is no MCAP file"};
  if (!record_at(bytes, magic.size()).fits) return {End::cut, 0, "ends within its header"};
  return {End::damaged, 0, "has a damaged header"};
}

/// Every record from `at` on.
Ending read_records(std::string_view bytes, std::uint64_t at, Channels& known, Handler& handler) {
  for (;;) {
    if (at == bytes.size()) return {End::cut, at, "was not finished"};
    const auto [opcode, content, fits] = record_at(bytes, at);
    if (!fits) return {End::cut, at, "ends within a record"};
    switch (opcode) {
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

}  // namespace

Ending read(std::string_view bytes, Handler& handler) {
  Channels known;
  if (const std::uint64_t at = behind_header(bytes); at != 0)
    return read_records(bytes, at, known, handler);
  const std::uint64_t at = find_first_chunk(bytes, known, handler);
  if (at == 0) return unfit(bytes);
  Ending ending = read_records(bytes, at, known, handler);
  // The CRC over all data, at their end, covers the header too.
  if (ending.all_data()) return {End::index, ending.valid_bytes, "has a damaged header"};
  ending.why = "has a damaged header and " + ending.why;
  return ending;
}

}  // namespace searig::acquisition::mcap
