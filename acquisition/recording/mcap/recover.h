// Everything of a damaged file that lies before the damage, as a whole file.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "acquisition/recording/mcap/reader.h"
#include "acquisition/recording/mcap/writer.h"

namespace searig::acquisition::mcap {

struct Recovered {
  Ending ending;                                  ///< of the damaged file
  std::map<std::string, std::uint64_t> messages;  ///< kept, by topic
  double seconds = 0.0;                           ///< from the first message kept to the last
};

/// Writes what read() hands on, chunk by chunk as it was, with an index behind it. Where there is
/// nothing to keep, nothing is sent and `messages` is empty.
Recovered recover(std::string_view bytes, const std::string& program, const Writer::Sink& sink);

}  // namespace searig::acquisition::mcap
