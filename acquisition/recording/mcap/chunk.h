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

}  // namespace searig::acquisition::mcap
