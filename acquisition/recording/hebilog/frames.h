// The frames of a .hebilog file. HEBI publishes no description; this was worked out from the one
// log that HEBI itself hands out (hebi-matlab-examples, basic/actuator/logs/exampleLog.hebilog,
// Apache-2.0, of 2018) and holds for every byte of it. Numbers are big-endian.
//
//     73 B1 | u16 type | the rest, by type:
//
//     type  what           rest
//     1     feedback       u64 address, u32 n, u64 log time, u16 n - 2, n - 2 bytes of protobuf
//     5     feedback with  the same; the message also holds what the module is (name, serial,
//           information    gains ...), asked for about five times a second on a sequence of its own
//     2     file header    u32 modules, a u64 address for each
//     4     format         u32 0, u32 0x51
//
// Address: u32 UDP port, IPv4 address. Log time: microseconds since 1970 on the host, when the
// feedback had arrived. No frame has a checksum: damage is seen where a length, the next frame's
// first bytes or the protobuf do not fit, and only there.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

namespace searig::acquisition::hebilog {

inline constexpr std::string_view magic = "\x73\xB1";

struct Frame {
  enum class Type : std::uint16_t { feedback = 1, header = 2, format = 4, information = 5 };
  Type type = Type::feedback;
  std::uint64_t address = 0;
  std::uint64_t log_us = 0;
  std::string_view message;  ///< protobuf
};

/// What could not be read as frames.
struct Damage {
  std::size_t places = 0;
  std::size_t bytes = 0;
  std::size_t first_at = 0;  ///< where in the file
  bool at_end = false;       ///< the last place reaches to the file's end: it was cut there
};

/// Hands on every whole frame, in the file's order. Where there is none, goes on at the next place
/// at which one begins. `take` says whether a message could be read; else its frame is damaged.
Damage read_frames(std::string_view file, const std::function<bool(const Frame&)>& take);

}  // namespace searig::acquisition::hebilog
