// A device's half of the wire, for tests: makes the frames that a decoder is to read.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "acquisition/wire/decoder.h"
#include "arduino/firmware/payloads.h"

namespace searig::acquisition {

using Bytes = std::vector<std::uint8_t>;

struct Sender {
  std::uint16_t boot = 7;
  std::map<wire::Type, std::uint32_t> sequences;

  template <typename Payload>
  Bytes frame(wire::Type type, const Payload& payload, std::uint32_t time_us,
              std::uint8_t version = wire::kProtocolVersion) {
    std::uint8_t content[Payload::kSize];
    payload.write(content);
    Bytes bytes(wire::kMaxEncoded);
    const wire::Header header{version, type, boot, sequences[type]++, time_us};
    bytes.resize(wire::encode(header, content, Payload::kSize, bytes.data()));
    return bytes;
  }

  Bytes loadcell(std::uint32_t time_us, std::int32_t counts, std::uint16_t overruns = 0) {
    return frame(wire::Type::loadcell_sample, wire::LoadcellPayload{counts, 0, overruns, 0},
                 time_us);
  }

  Bytes module(std::uint32_t time_us, std::int32_t input_urad) {
    wire::ModulePayload payload{};
    payload.input_angle_urad = input_urad;
    payload.commanded_angle_urad = wire::kAbsent32;
    payload.spring_temperature_cc = wire::kAbsent16;
    return frame(wire::Type::module_sample, payload, time_us);
  }

  /// After a restart: the next boot, all sequences from 0.
  void restart() {
    ++boot;
    sequences.clear();
  }
};

inline std::vector<Message> decode_all(Decoder& decoder, const std::vector<Bytes>& frames,
                                       double step_s = 0.02) {
  std::vector<Message> messages;
  double host_s = 100.0;
  for (const Bytes& bytes : frames) decoder.push(bytes, host_s += step_s, messages);
  return messages;
}

template <typename T>
std::vector<T> only(const std::vector<Message>& messages) {
  std::vector<T> found;
  for (const Message& message : messages) {
    if (const T* one = std::get_if<T>(&message)) found.push_back(*one);
  }
  return found;
}

}  // namespace searig::acquisition
