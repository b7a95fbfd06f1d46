// CRC-16/CCITT-FALSE: polynomial 0x1021, start 0xFFFF, bits as they are, nothing added at the end.
// Finds every error of up to three bits in the frames here (Hamming distance 4 up to 32751 bits).
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace searig {
namespace wire {

inline uint16_t crc16(const uint8_t* bytes, size_t size) {
  uint16_t crc = 0xFFFF;
  for (size_t i = 0; i < size; ++i) {
    // Eight bits at once: x is what leaves at the top, and the polynomial has three further terms.
    uint8_t x = static_cast<uint8_t>((crc >> 8) ^ bytes[i]);
    x = static_cast<uint8_t>(x ^ (x >> 4));
    crc = static_cast<uint16_t>((crc << 8) ^ (static_cast<uint16_t>(x) << 12) ^
                                (static_cast<uint16_t>(x) << 5) ^ x);
  }
  return crc;
}

}  // namespace wire
}  // namespace searig
