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
    crc = static_cast<uint16_t>(crc ^ static_cast<uint16_t>(bytes[i] << 8));
    for (uint8_t bit = 0; bit < 8; ++bit) {
      const bool out = (crc & 0x8000) != 0;
      crc = static_cast<uint16_t>(crc << 1);
      if (out) crc = static_cast<uint16_t>(crc ^ 0x1021);
    }
  }
  return crc;
}

}  // namespace wire
}  // namespace searig
