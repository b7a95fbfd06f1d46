// One chunk of an MCAP file: checked as a whole, then handed on message by message.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "acquisition/recording/mcap/reader.h"

namespace searig::acquisition::mcap {

/// The schemas and channels of the chunks so far.
struct Channels {
  std::map<std::uint16_t, Schema> schemas;
  std::map<std::uint16_t, Channel> channels;
  std::map<std::uint16_t, std::uint32_t> next;  ///< sequence that a channel's next message bears
};

/// Hands on what the content of a chunk record holds, or nothing where any of it is not as written;
/// then says in half a sentence what is wrong. Empty where all is well.
std::string read_chunk(std::string_view content, Channels& known, Handler& handler);

/// The records in the content of a chunk that read_chunk() found well, and their CRC.
std::string_view records_of(std::string_view content);
std::uint32_t crc_of_chunk(std::string_view content);

/// Hands on what such a chunk holds, without looking into it once more.
void hand_on_again(std::string_view content, Channels& known, Handler& handler);

}  // namespace searig::acquisition::mcap
