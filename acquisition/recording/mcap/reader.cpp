#include "acquisition/recording/mcap/reader.h"

#include <algorithm>

#include "acquisition/recording/mcap/chunk.h"

namespace searig::acquisition::mcap {
namespace {

constexpr std::uint64_t record_head = 1 + 8;       // opcode and length
constexpr std::uint64_t longest_search = 1 << 16;  // bytes, for the first chunk
constexpr std::uint64_t crc_size = sizeof(std::uint32_t);
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

/// The CRC of a file's bytes from its beginning, taken as reading goes on: no byte twice, and those
/// behind need not stay in memory.
class RunningCrc {
 public:
  RunningCrc(std::string_view bytes, Handler& handler) : bytes_(bytes), handler_(handler) {}

  /// Up to `end`; returns the CRC of what was taken.
  std::uint32_t take(std::uint64_t end) {
    constexpr std::uint64_t step = 1 << 20;
    std::uint32_t taken = 0;
    const std::uint64_t from = done_;
    while (done_ < end) {
      const std::uint64_t next = std::min(end, done_ + step);
      taken = crc32_of(bytes_.substr(done_, next - done_), taken);
      done_ = next;
      if (done_ - told_ < step) continue;
      handler_.passed(done_);
      told_ = done_;
    }
    crc_ = joined_crc32(crc_, taken, done_ - from);
    return taken;
  }

  /// Up to `end`, the bytes of `part`, which ends there, being known by their CRC.
  void take(std::uint64_t end, std::string_view part, std::uint32_t crc_of_part) {
    take(end - part.size());
    crc_ = joined_crc32(crc_, crc_of_part, part.size());
    done_ = end;
    take(end);
  }

  std::uint32_t value() const { return crc_; }

 private:
  std::string_view bytes_;
  Handler& handler_;
  std::uint64_t done_ = 0, told_ = 0;
  std::uint32_t crc_ = 0;
};

/// What follows the data: index, footer, magic. `at` is where the DataEnd record begins, `crc` that
/// of all before.
Ending read_end(std::string_view bytes, std::uint64_t at, std::string_view data_end,
                std::uint32_t crc_before) {
  const auto data_crc = ByteReader(data_end).take<std::uint32_t>();
  if (data_crc != 0 && data_crc != crc_before)
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
  RunningCrc crc(bytes, handler);
  for (;;) {
    crc.take(at);
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
        crc.take(at + record_head + content.size(), records_of(content), crc_of_chunk(content));
        break;
      case Opcode::attachment: {
        const std::uint64_t end = at + record_head + content.size();
        crc.take(at + record_head);
        const std::uint32_t crc_of_it = crc.take(std::max(end - std::min(end, crc_size), at));
        const Parsed<Attachment> parsed = parse_attachment(content, crc_of_it);
        if (!parsed.fits) return {End::damaged, at, "has a damaged attachment"};
        handler.attachment(parsed.record);
        break;
      }
      case Opcode::data_end:
        if (content.size() != sizeof(std::uint32_t))
          return {End::damaged, at, "has a damaged record"};
        return read_end(bytes, at, content, crc.value());
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

void read_again(std::string_view bytes, Handler& handler) {
  Channels known;
  std::uint64_t at = behind_header(bytes);
  while (at < bytes.size()) {
    const auto [opcode, content, fits] = record_at(bytes, at);
    if (!fits || opcode == Opcode::data_end) break;
    if (opcode == Opcode::chunk) {
      hand_on_again(content, known, handler);
      handler.passed(at);
    }
    at += record_head + content.size();
  }
}

}  // namespace searig::acquisition::mcap
