#include "acquisition/recording/mcap/chunk.h"

#include <algorithm>
#include <limits>

namespace searig::acquisition::mcap {
namespace {

struct Head {
  std::uint64_t from_ns = 0, to_ns = 0, size = 0;
  std::uint32_t crc = 0;
  std::string_view compression, records;
};

Parsed<Head> parse_head(std::string_view content) {
  ByteReader reader(content);
  Head head;
  head.from_ns = reader.take<std::uint64_t>();
  head.to_ns = reader.take<std::uint64_t>();
  head.size = reader.take<std::uint64_t>();
  head.crc = reader.take<std::uint32_t>();
  head.compression = reader.take_sized<std::uint32_t>();
  head.records = reader.take_sized<std::uint64_t>();
  return {head, !reader.ran_out() && reader.empty()};
}

/// A definition may come again, but not as another.
template <typename Definition>
bool define(std::map<std::uint16_t, Definition>& known, const Parsed<Definition>& parsed) {
  if (!parsed.fits) return false;
  const auto [place, fresh] = known.emplace(parsed.record.id, parsed.record);
  return fresh || place->second == parsed.record;
}

/// Calls take(opcode, content) for each record; false where one does not fit or is refused.
template <typename Take>
bool for_each_record(std::string_view records, Take take) {
  ByteReader reader(records);
  while (!reader.empty()) {
    const auto opcode = static_cast<Opcode>(reader.take<std::uint8_t>());
    const std::string_view content = reader.take_sized<std::uint64_t>();
    if (reader.ran_out() || !take(opcode, content)) return false;
  }
  return true;
}

/// Whether this is the message that follows the channel's last one: none in between was skipped.
bool follows(const Message& message, Channels& known) {
  const auto next = known.next.emplace(message.channel, message.sequence).first;
  return message.sequence == next->second++;
}

/// New channels, with what their messages look like.
void announce(const Channels& before, const Channels& now, Handler& handler) {
  for (const auto& [id, channel] : now.channels) {
    if (before.channels.contains(id)) continue;
    const auto schema = now.schemas.find(channel.schema);
    handler.channel(channel, schema == now.schemas.end() ? Schema{} : schema->second);
  }
}

/// Everything but the handing on: definitions into `known`, times against the head's.
bool check(const Head& head, Channels& known) {
  std::uint64_t from_ns = std::numeric_limits<std::uint64_t>::max(), to_ns = 0;
  const bool fits = for_each_record(head.records, [&](Opcode opcode, std::string_view content) {
    if (opcode == Opcode::schema) return define(known.schemas, parse_schema(content));
    if (opcode == Opcode::channel) {
      const Parsed<Channel> parsed = parse_channel(content);
      return (parsed.record.schema == 0 || known.schemas.contains(parsed.record.schema)) &&
             define(known.channels, parsed);
    }
    if (opcode != Opcode::message) return false;
    const Parsed<Message> parsed = parse_message(content);
    from_ns = std::min(from_ns, parsed.record.log_time_ns);
    to_ns = std::max(to_ns, parsed.record.log_time_ns);
    return parsed.fits && known.channels.contains(parsed.record.channel) &&
           follows(parsed.record, known);
  });
  return fits && (from_ns > to_ns || (from_ns == head.from_ns && to_ns == head.to_ns));
}

}  // namespace

std::string read_chunk(std::string_view content, Channels& known, Handler& handler) {
  const Parsed<Head> parsed = parse_head(content);
  const Head& head = parsed.record;
  if (!parsed.fits) return "a chunk's lengths do not fit";
  if (head.compression == "zstd" || head.compression == "lz4")
    return "a chunk is compressed, which is not read here";
  if (!head.compression.empty() || head.size != head.records.size() ||
      crc32_of(head.records) != head.crc)
    return "a chunk's CRC does not fit";

  Channels with_these = known;
  if (!check(head, with_these)) return "a chunk's records do not fit";
  announce(known, with_these, handler);
  known = std::move(with_these);
  for_each_record(head.records, [&](Opcode opcode, std::string_view record) {
    if (opcode == Opcode::message) handler.message(parse_message(record).record);
    return true;
  });
  handler.chunk_ended();
  return {};
}

std::string_view records_of(std::string_view content) {
  return parse_head(content).record.records;
}

std::uint32_t crc_of_chunk(std::string_view content) {
  return parse_head(content).record.crc;
}

void hand_on_again(std::string_view content, Channels& known, Handler& handler) {
  for_each_record(records_of(content), [&](Opcode opcode, std::string_view record) {
    if (opcode == Opcode::schema || opcode == Opcode::channel) {
      const Channels before = known;
      if (opcode == Opcode::schema) define(known.schemas, parse_schema(record));
      if (opcode == Opcode::channel) define(known.channels, parse_channel(record));
      announce(before, known, handler);
    } else {
      handler.message(parse_message(record).record);
    }
    return true;
  });
  handler.chunk_ended();
}

}  // namespace searig::acquisition::mcap
