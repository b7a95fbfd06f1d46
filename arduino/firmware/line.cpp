#include "line.h"

#include <Arduino.h>

#include "settings.h"

using namespace searig::wire;

namespace {

uint16_t boot_number;
uint32_t sequences[5];  // by type

uint8_t received[kMaxEncoded];
uint8_t received_size = 0;  // kMaxEncoded where it is too long

// Whether what was received is a request; its payload is copied.
bool understand(Request* request) {
  const size_t size = cobs_decode(received, received_size, received);
  if (!crc_holds(received, size)) return false;
  const Header header = read_header(received);
  const int expected = payload_size(header.type);
  if (header.version != kProtocolVersion || expected < 0) return false;
  if (size != kHeaderSize + static_cast<size_t>(expected) + kCrcSize) return false;
  request->type = header.type;
  memcpy(request->payload, received + kHeaderSize, expected);
  return true;
}

}  // namespace

void line_begin(uint16_t boot) {
  boot_number = boot;
  Serial.begin(kBaud);
  Serial.write(static_cast<uint8_t>(0));  // ends what a reset cut short
}

bool line_send(Type type, uint32_t time_us, const uint8_t* payload, uint8_t size) {
  const int encoded_size = kHeaderSize + size + kCrcSize + 2;
  if (Serial.availableForWrite() < encoded_size) return false;
  Header header;
  header.version = kProtocolVersion;
  header.type = type;
  header.boot = boot_number;
  header.sequence = sequences[static_cast<uint8_t>(type)]++;
  header.time_us = time_us;
  uint8_t encoded[kMaxEncoded];
  Serial.write(encoded, encode(header, payload, size, encoded));
  return true;
}

bool line_idle() {
  return Serial.availableForWrite() >= SERIAL_TX_BUFFER_SIZE - 1;
}

bool line_heard() {
  return Serial.available() > 0;
}

bool line_receive(Request* request) {
  while (Serial.available() > 0) {
    const uint8_t byte = Serial.read();
    if (byte != 0) {
      if (received_size < kMaxEncoded) received[received_size++] = byte;
      continue;
    }
    request->received_us = micros();
    const bool whole = received_size > 0 && received_size < kMaxEncoded && understand(request);
    received_size = 0;
    if (whole) return true;
  }
  return false;
}
