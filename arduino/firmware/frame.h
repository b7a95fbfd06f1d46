// The wire: the one definition of a frame, for the firmware, the modules and the host. C++11, no
// library, so that the Arduino IDE and Debian's avr-gcc build it.
//
// On the wire:  COBS( header | payload | CRC-16 ) 0x00
//
//   offset  size  header, little-endian as everything here
//   0       1     protocol version
//   1       1     type, which fixes the payload's size
//   2       2     boot: one more at each start of the device, so that a restart cannot be missed
//   4       4     sequence: counts the frames of this type since the start
//   8       4     device time, us, of what the frame tells; wraps after 71.6 min
//
// The CRC is over header and payload. Payloads: payloads.h.
#pragma once

#include <string.h>

#include "cobs.h"
#include "crc16.h"

namespace searig {
namespace wire {

const uint8_t kProtocolVersion = 1;
const size_t kHeaderSize = 12;
const size_t kCrcSize = 2;
const size_t kMaxPayload = 48;
const size_t kMaxFrame = kHeaderSize + kMaxPayload + kCrcSize;
const size_t kMaxEncoded = kMaxFrame + 2;  // with COBS's byte and the ending zero

enum class Type : uint8_t {
  loadcell_sample = 1,  // device to host
  module_sample = 2,
  identity = 3,
  pong = 4,
  ping = 0x81,  // host to device
  identify = 0x82,
  set_calibration = 0x83,
  set_name = 0x84
};

struct Header {
  uint8_t version;
  Type type;
  uint16_t boot;
  uint32_t sequence;
  uint32_t time_us;
};

/// Writes numbers one after the other, low byte first.
class Writer {
 public:
  explicit Writer(uint8_t* to) : to_(to) {}
  void u8(uint8_t v) { *to_++ = v; }
  void u16(uint16_t v) { u8(static_cast<uint8_t>(v)), u8(static_cast<uint8_t>(v >> 8)); }
  void u32(uint32_t v) { u16(static_cast<uint16_t>(v)), u16(static_cast<uint16_t>(v >> 16)); }
  void i16(int16_t v) { u16(static_cast<uint16_t>(v)); }
  void i32(int32_t v) { u32(static_cast<uint32_t>(v)); }
  void u64(uint64_t v) { u32(static_cast<uint32_t>(v)), u32(static_cast<uint32_t>(v >> 32)); }
  void f32(float v) {  // IEEE 754 binary32, which is what a float is on either side
    uint32_t bits;
    memcpy(&bits, &v, sizeof bits);
    u32(bits);
  }
  void text(const char* v, size_t size) { memcpy(to_, v, size), to_ += size; }

 private:
  uint8_t* to_;
};

class Reader {
 public:
  explicit Reader(const uint8_t* from) : from_(from) {}
  uint8_t u8() { return *from_++; }
  uint16_t u16() {
    const uint16_t low = u8();
    return static_cast<uint16_t>(low | (u8() << 8));
  }
  uint32_t u32() {
    const uint32_t low = u16();
    return low | (static_cast<uint32_t>(u16()) << 16);
  }
  uint64_t u64() {
    const uint64_t low = u32();
    return low | (static_cast<uint64_t>(u32()) << 32);
  }
  int16_t i16() { return static_cast<int16_t>(u16()); }
  int32_t i32() { return static_cast<int32_t>(u32()); }
  float f32() {
    const uint32_t bits = u32();
    float v;
    memcpy(&v, &bits, sizeof v);
    return v;
  }
  void text(char* v, size_t size) { memcpy(v, from_, size), from_ += size; }

 private:
  const uint8_t* from_;
};

/// Encodes a frame with its ending zero; `out` takes kMaxEncoded bytes. Returns how many.
inline size_t encode(const Header& header, const uint8_t* payload, size_t size, uint8_t* out) {
  uint8_t frame[kMaxFrame];
  Writer put(frame);
  put.u8(header.version);
  put.u8(static_cast<uint8_t>(header.type));
  put.u16(header.boot);
  put.u32(header.sequence);
  put.u32(header.time_us);
  if (size > 0) memcpy(frame + kHeaderSize, payload, size);
  Writer(frame + kHeaderSize + size).u16(crc16(frame, kHeaderSize + size));
  const size_t encoded = cobs_encode(frame, kHeaderSize + size + kCrcSize, out);
  out[encoded] = 0;
  return encoded + 1;
}

inline Header read_header(const uint8_t* frame) {
  Reader get(frame);
  Header header;
  header.version = get.u8();
  header.type = static_cast<Type>(get.u8());
  header.boot = get.u16();
  header.sequence = get.u32();
  header.time_us = get.u32();
  return header;
}

/// Whether a decoded frame of this size, header to CRC, carries its own check.
inline bool crc_holds(const uint8_t* frame, size_t size) {
  return size >= kHeaderSize + kCrcSize &&
         Reader(frame + size - kCrcSize).u16() == crc16(frame, size - kCrcSize);
}

}  // namespace wire
}  // namespace searig
