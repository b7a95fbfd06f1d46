// A .hebilog written by hand: frames and protobuf as frames.h and message.h tell of them.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace searig::acquisition::hebilog {

inline std::string big_endian(std::uint64_t value, int size) {
  std::string bytes;
  for (int i = size; i-- > 0;) bytes += char(value >> (8 * i));
  return bytes;
}

inline std::string varint(std::uint64_t value) {
  std::string bytes;
  for (; value >= 0x80; value >>= 7) bytes += char(value | 0x80);
  return bytes + char(value);
}

inline std::string integer(unsigned number, std::uint64_t value) {
  return varint(number << 3) + varint(value);
}

inline std::string real(unsigned number, float value) {
  std::string bytes = varint(number << 3 | 5);
  const auto bits = std::bit_cast<std::uint32_t>(value);
  for (int i = 0; i < 4; ++i) bytes += char(bits >> (8 * i));
  return bytes;
}

inline std::string message(unsigned number, const std::string& inside) {
  return varint(number << 3 | 2) + varint(inside.size()) + inside;
}

inline std::string frame(unsigned type, std::uint64_t address, std::uint64_t log_us,
                         const std::string& inside) {
  return "\x73\xB1" + big_endian(type, 2) + big_endian(address, 8) +
         big_endian(inside.size() + 2, 4) + big_endian(log_us, 8) + big_endian(inside.size(), 2) +
         inside;
}

inline std::string header(const std::vector<std::uint64_t>& addresses) {
  std::string bytes = "\x73\xB1" + big_endian(2, 2) + big_endian(addresses.size(), 4);
  for (const auto address : addresses) bytes += big_endian(address, 8);
  return bytes + "\x73\xB1" + big_endian(4, 2) + big_endian(0, 4) + big_endian(0x51, 4);
}

/// What row i of a log at 100 Hz holds. Until row 5 there is no command.
inline std::string feedback(int i) {
  const auto us = std::uint64_t(10000) * std::uint64_t(i);
  const float angle = 0.01f * float(i), no_number = std::bit_cast<float>(0x7fc00000u);
  return integer(1, 77) + integer(3, 4000000 + us) + integer(5, 4000090 + us) +
         message(8, integer(1, 1500000000000100 + us) + integer(2, std::uint64_t(i) + 1)) +
         message(10,
                 message(9, real(1, i < 5 ? no_number : angle) + real(2, i < 5 ? no_number : 1))) +
         message(11, real(3, 24.5f) + message(9, real(1, angle) + real(3, -4.0f * angle) +
                                                     real(4, 0.1f * angle) + real(11, 0.5f))) +
         message(14, integer(3, std::uint64_t(-2)));
}

inline std::string information() {
  return integer(5, 1) + message(20, message(1, message(1, "Wrist") + message(2, "Arm"))) +
         message(1012, message(1, "X-00007") + message(6, "X5-1"));
}

inline constexpr std::uint64_t one_address = 0x000041190a0a0ac3;

inline std::string a_log(int rows, std::uint64_t address = one_address) {
  std::string bytes = header({address});
  for (int i = 0; i < rows; ++i) {
    bytes += frame(1, address, 1500000000001000 + 10000 * std::uint64_t(i), feedback(i));
    if (i % 20 == 10) bytes += frame(5, address, 1500000000005000, information());
  }
  return bytes;
}

}  // namespace searig::acquisition::hebilog
