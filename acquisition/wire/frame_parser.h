// Bytes -> frames that carry their own check. What does not is counted by what is wrong with it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "arduino/firmware/payloads.h"

namespace searig::acquisition {

struct Frame {
  wire::Header header;
  std::array<std::uint8_t, wire::kMaxPayload> payload;  ///< as long as payload_size(header.type)
  double host_s = 0.0;                                  ///< arrival of its last byte
};

struct ParserCounters {
  std::uint64_t bytes = 0;
  std::uint64_t frames = 0;         ///< good ones
  std::uint64_t bad_crc = 0;        ///< long enough for a frame, but not what was sent
  std::uint64_t malformed = 0;      ///< no encoding, or of a length that no frame of its type has
  std::uint64_t too_long = 0;       ///< no end where the longest frame would have ended
  std::uint64_t other_version = 0;  ///< good, but of another version of the protocol
  std::uint64_t unknown_type = 0;   ///< good, but nothing that a device sends
  std::uint64_t cut = 0;  ///< begun before we listened or ended by a gap: no fault of the line
};

class FrameParser {
 public:
  /// Appends the frames that these bytes complete.
  void push(std::span<const std::uint8_t> bytes, double host_s, std::vector<Frame>& frames);

  /// What has been begun does not go on; what comes may begin in the midst of a frame.
  void gap();

  /// What has been begun does not go on, and that is an error: the end of a datagram.
  void end();

  const ParserCounters& counters() const { return counters_; }

 private:
  void finish(double host_s, std::vector<Frame>& frames);
  std::uint64_t* judge(std::span<const std::uint8_t> decoded);

  std::array<std::uint8_t, wire::kMaxEncoded> encoded_;
  std::size_t size_ = 0;     ///< of what has been begun; one more than fits where it is too long
  bool from_start_ = false;  ///< whether its first byte is known to begin a frame
  ParserCounters counters_;
};

}  // namespace searig::acquisition
