// Reads an MCAP file from its beginning up to the first damage, and nothing beyond.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "acquisition/recording/mcap/format.h"

namespace searig::acquisition::mcap {

/// Takes what a file holds, in its order. Views and references live as long as the call.
class Handler {
 public:
  virtual ~Handler() = default;
  /// Before the first message of the channel.
  virtual void channel(const Channel& channel, const Schema& schema) = 0;
  virtual void message(const Message& message) = 0;
  virtual void chunk_ended() {}
  virtual void attachment(const Attachment&) {}
  /// So many bytes of the file are not needed any more.
  virtual void passed(std::uint64_t) {}
};

/// Where reading ended, and why there.
enum class End {
  whole,    ///< at the end of a file that was finished
  index,    ///< all data are whole; only the header before or the index behind them is not
  cut,      ///< the file stops: its recorder was killed, or it is still being written
  damaged,  ///< bytes are not what was written
  unfit     ///< no MCAP file, or one of a kind that is not read here
};

struct Ending {
  End end = End::whole;
  std::uint64_t valid_bytes = 0;  ///< the data that were read lie before this
  std::string why;                ///< half a sentence: "ends within a chunk"
  bool all_data() const { return end == End::whole || end == End::index; }
};

/// Every value handed on has passed a CRC-32, so that no single flipped bit and no cut can change
/// one; a chunk is handed on whole or not at all. What lies outside the CRCs (lengths, opcodes, the
/// times of a chunk) is checked against what lies inside; messages outside of chunks and compressed
/// chunks are not read. The index at the end is not used; where the header is damaged, reading
/// begins at the first chunk.
Ending read(std::string_view bytes, Handler& handler);

/// The messages of bytes that read() went through before and found whole: without checking them
/// once more, and without attachments.
void read_again(std::string_view bytes, Handler& handler);

}  // namespace searig::acquisition::mcap
