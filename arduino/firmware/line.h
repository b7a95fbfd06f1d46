// Frames to and from the host over the serial line. Nothing here waits: a frame goes when there is
// room for the whole of it.
#pragma once

#include "payloads.h"

void line_begin(uint16_t boot);

// Whether a frame with such a payload could be sent now; only then is it.
bool line_send(searig::wire::Type type, uint32_t time_us, const uint8_t* payload, uint8_t size);

// Whether the line has nothing more to send, but for the byte on its way.
bool line_idle();

// Whether there are bytes from the host.
bool line_heard();

// Whether the host's next frame is whole. Its payload is as long as its type says.
struct Request {
  searig::wire::Type type;
  uint32_t received_us;  // when its last byte was seen
  uint8_t payload[searig::wire::kMaxPayload];
};
bool line_receive(Request* request);
