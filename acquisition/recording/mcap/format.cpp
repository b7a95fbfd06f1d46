#include "acquisition/recording/mcap/format.h"

#include <zlib.h>

#include <algorithm>

namespace searig::acquisition::mcap {
namespace {

Texts take_texts(ByteReader& reader) {
  ByteReader entries(reader.take_sized<std::uint32_t>());
  Texts texts;
  while (!entries.empty()) {
    const auto key = entries.take_sized<std::uint32_t>();
    texts.emplace(key, entries.take_sized<std::uint32_t>());
  }
  // A text that reaches beyond the map is found by asking for more than there is.
  if (entries.ran_out()) reader.take_bytes(reader.size() + 1);
  return texts;
}

template <typename Record>
Parsed<Record> ended(Record record, const ByteReader& reader) {
  return {std::move(record), !reader.ran_out() && reader.empty()};
}

}  // namespace

void put_record(std::string& bytes, Opcode opcode, std::string_view content) {
  put(bytes, static_cast<std::uint8_t>(opcode));
  put_sized<std::uint64_t>(bytes, content);
}

void put_texts(std::string& bytes, const Texts& texts) {
  std::string entries;
  for (const auto& [key, value] : texts) {
    put_sized<std::uint32_t>(entries, key);
    put_sized<std::uint32_t>(entries, value);
  }
  put_sized<std::uint32_t>(bytes, entries);
}

void put_schema(std::string& bytes, const Schema& schema) {
  std::string content;
  put(content, schema.id);
  put_sized<std::uint32_t>(content, schema.name);
  put_sized<std::uint32_t>(content, schema.encoding);
  put_sized<std::uint32_t>(content, schema.text);
  put_record(bytes, Opcode::schema, content);
}

void put_channel(std::string& bytes, const Channel& channel) {
  std::string content;
  put(content, channel.id);
  put(content, channel.schema);
  put_sized<std::uint32_t>(content, channel.topic);
  put_sized<std::uint32_t>(content, channel.encoding);
  put_texts(content, channel.metadata);
  put_record(bytes, Opcode::channel, content);
}

void put_message(std::string& bytes, const Message& message) {
  // At 1 kHz and more this is the hot one, so nothing is built on the side.
  constexpr std::uint64_t head = 2 + 4 + 8 + 8;
  put(bytes, static_cast<std::uint8_t>(Opcode::message));
  put(bytes, head + message.data.size());
  put(bytes, message.channel);
  put(bytes, message.sequence);
  put(bytes, message.log_time_ns);
  put(bytes, message.made_time_ns);
  bytes.append(message.data);
}

void put_attachment(std::string& bytes, const Attachment& attachment) {
  std::string content;
  put(content, attachment.log_time_ns);
  put(content, attachment.made_time_ns);
  put_sized<std::uint32_t>(content, attachment.name);
  put_sized<std::uint32_t>(content, attachment.media_type);
  put_sized<std::uint64_t>(content, attachment.data);
  put(content, crc32_of(content));
  put_record(bytes, Opcode::attachment, content);
}

Parsed<Schema> parse_schema(std::string_view content) {
  ByteReader reader(content);
  Schema schema;
  schema.id = reader.take<std::uint16_t>();
  schema.name = reader.take_sized<std::uint32_t>();
  schema.encoding = reader.take_sized<std::uint32_t>();
  schema.text = reader.take_sized<std::uint32_t>();
  return ended(std::move(schema), reader);
}

Parsed<Channel> parse_channel(std::string_view content) {
  ByteReader reader(content);
  Channel channel;
  channel.id = reader.take<std::uint16_t>();
  channel.schema = reader.take<std::uint16_t>();
  channel.topic = reader.take_sized<std::uint32_t>();
  channel.encoding = reader.take_sized<std::uint32_t>();
  channel.metadata = take_texts(reader);
  return ended(std::move(channel), reader);
}

Parsed<Message> parse_message(std::string_view content) {
  ByteReader reader(content);
  Message message;
  message.channel = reader.take<std::uint16_t>();
  message.sequence = reader.take<std::uint32_t>();
  message.log_time_ns = reader.take<std::uint64_t>();
  message.made_time_ns = reader.take<std::uint64_t>();
  message.data = reader.take_bytes(reader.size());
  return ended(message, reader);
}

Parsed<Attachment> parse_attachment(std::string_view content) {
  const std::size_t own = std::min(content.size(), sizeof(std::uint32_t));
  return parse_attachment(content, crc32_of(content.substr(0, content.size() - own)));
}

Parsed<Attachment> parse_attachment(std::string_view content, std::uint32_t crc_of_it) {
  ByteReader reader(content);
  Attachment attachment;
  attachment.log_time_ns = reader.take<std::uint64_t>();
  attachment.made_time_ns = reader.take<std::uint64_t>();
  attachment.name = reader.take_sized<std::uint32_t>();
  attachment.media_type = reader.take_sized<std::uint32_t>();
  attachment.data = reader.take_sized<std::uint64_t>();
  const auto crc = reader.take<std::uint32_t>();
  Parsed<Attachment> parsed = ended(std::move(attachment), reader);
  parsed.fits = parsed.fits && crc == crc_of_it;
  return parsed;
}

std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before) {
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

std::uint32_t joined_crc32(std::uint32_t first, std::uint32_t second, std::uint64_t size) {
  return static_cast<std::uint32_t>(crc32_combine(first, second, static_cast<z_off_t>(size)));
}

}  // namespace searig::acquisition::mcap
