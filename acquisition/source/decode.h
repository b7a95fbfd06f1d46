// Arrivals -> messages: the one way that live, replayed and batch decoding share.
#pragma once

#include <string_view>
#include <vector>

#include "acquisition/source/source.h"
#include "acquisition/wire/decoder.h"

namespace searig::acquisition {

/// How frames come from a source of this name, simulated ("sim:udp:...") or not.
inline Framing framing_of(std::string_view source_name) {
  return source_name.find("udp:") != std::string_view::npos ? Framing::datagrams : Framing::stream;
}

/// The decoder for what comes from a source of this name.
inline Decoder decoder_for(std::string_view source_name) {
  return Decoder(framing_of(source_name));
}

/// Appends the messages that an arrival completes. Given the same arrivals in the same order, the
/// messages are the same to the last bit.
inline void decode(const Arrival& arrival, Decoder& decoder, std::vector<Message>& messages) {
  if (arrival.kind == Arrival::Kind::bytes) {
    decoder.push(arrival.bytes, arrival.host_s, messages);
  } else if (arrival.kind == Arrival::Kind::unplugged) {
    decoder.gap();
  }
}

}  // namespace searig::acquisition
