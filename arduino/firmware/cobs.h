// Consistent overhead byte stuffing (Cheshire and Baker 1999): bytes without a zero, so that a zero
// can end a frame and the first whole frame after any damage is read right.
#pragma once

#include <stddef.h>
#include <stdint.h>

namespace searig {
namespace wire {

/// Encodes up to 254 bytes, without the ending zero; `out` takes size + 1 bytes. Returns how many.
inline size_t cobs_encode(const uint8_t* bytes, size_t size, uint8_t* out) {
  size_t code = 0;  // where the distance to the next zero goes
  size_t end = 1;
  for (size_t i = 0; i < size; ++i) {
    if (bytes[i] != 0) {
      out[end++] = bytes[i];
    } else {
      out[code] = static_cast<uint8_t>(end - code);
      code = end++;
    }
  }
  out[code] = static_cast<uint8_t>(end - code);
  return end;
}

/// Decodes what cobs_encode made, without the ending zero; `out` takes size - 1 bytes and may be
/// `bytes` itself. Returns how many, or 0 where this is no such encoding.
inline size_t cobs_decode(const uint8_t* bytes, size_t size, uint8_t* out) {
  size_t end = 0;
  size_t i = 0;
  while (i < size) {
    const uint8_t code = bytes[i++];
    if (code == 0 || code == 0xFF || size - i < static_cast<size_t>(code - 1)) return 0;
    for (uint8_t k = 1; k < code; ++k) {
      if (bytes[i] == 0) return 0;
      out[end++] = bytes[i++];
    }
    if (i < size) out[end++] = 0;
  }
  return end;
}

}  // namespace wire
}  // namespace searig
