// The records of an MCAP file, as https://mcap.dev/spec has them.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "acquisition/recording/mcap/bytes.h"

namespace searig::acquisition::mcap {

inline constexpr std::string_view magic = "\x89MCAP0\r\n";

/// A record is its opcode, the length of its content as uint64, and the content.
enum class Opcode : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  attachment = 0x09,
  attachment_index = 0x0A,
  statistics = 0x0B,
  metadata = 0x0C,
  metadata_index = 0x0D,
  summary_offset = 0x0E,
  data_end = 0x0F
};

using Texts = std::map<std::string, std::string>;

/// What the messages of a channel look like.
struct Schema {
  std::uint16_t id = 0;  ///< from 1
  std::string name;      ///< "searig/module"
  std::string encoding;  ///< "ros2msg"
  std::string text;
  bool operator==(const Schema&) const = default;
};

struct Channel {
  std::uint16_t id = 0;
  std::uint16_t schema = 0;
  std::string topic;     ///< "/module"
  std::string encoding;  ///< "cdr"
  Texts metadata;
  bool operator==(const Channel&) const = default;
};

/// One message; `data` belongs to whoever holds the bytes.
struct Message {
  std::uint16_t channel = 0;
  std::uint32_t sequence = 0;      ///< from 0, for each channel
  std::uint64_t log_time_ns = 0;   ///< when it was recorded
  std::uint64_t made_time_ns = 0;  ///< when it was made ("publish time")
  std::string_view data;
};

struct Attachment {
  std::uint64_t log_time_ns = 0;
  std::uint64_t made_time_ns = 0;
  std::string name;
  std::string media_type;
  std::string_view data;
};

void put_record(std::string& bytes, Opcode opcode, std::string_view content);
void put_texts(std::string& bytes, const Texts& texts);

/// Whole records, appended to bytes.
void put_schema(std::string& bytes, const Schema& schema);
void put_channel(std::string& bytes, const Channel& channel);
void put_message(std::string& bytes, const Message& message);
void put_attachment(std::string& bytes, const Attachment& attachment);

/// The content of such records. `fits` is false where it is not exactly such a record; of an
/// attachment, also where its CRC says otherwise.
template <typename Record>
struct Parsed {
  Record record;
  bool fits = false;
};
Parsed<Schema> parse_schema(std::string_view content);
Parsed<Channel> parse_channel(std::string_view content);
Parsed<Message> parse_message(std::string_view content);
Parsed<Attachment> parse_attachment(std::string_view content);
/// The same where the CRC of all but the content's last four bytes, its own CRC, is known.
Parsed<Attachment> parse_attachment(std::string_view content, std::uint32_t crc_of_it);

/// CRC-32 as in zlib; `before` is that of the bytes before these.
std::uint32_t crc32_of(std::string_view bytes, std::uint32_t before = 0);

/// The CRC-32 of bytes followed by `size` others, from the CRCs of both.
std::uint32_t joined_crc32(std::uint32_t first, std::uint32_t second, std::uint64_t size);

}  // namespace searig::acquisition::mcap
