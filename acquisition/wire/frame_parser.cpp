#include "acquisition/wire/frame_parser.h"

#include <algorithm>

namespace searig::acquisition {
namespace {

constexpr std::size_t kLongest = wire::kMaxEncoded - 1;  // without the ending zero

bool sent_by_devices(wire::Type type) {
  return static_cast<std::uint8_t>(type) < 0x80;
}

}  // namespace

void FrameParser::push(std::span<const std::uint8_t> bytes, double host_s,
                       std::vector<Frame>& frames) {
  counters_.bytes += bytes.size();
  for (const std::uint8_t byte : bytes) {
    if (byte == 0) {
      finish(host_s, frames);
    } else if (size_ < kLongest) {
      encoded_[size_++] = byte;
    } else {
      size_ = kLongest + 1;
    }
  }
}

void FrameParser::gap() {
  if (size_ > 0) ++counters_.cut;
  size_ = 0;
  from_start_ = false;
}

void FrameParser::end() {
  if (size_ > 0) ++(size_ > kLongest ? counters_.too_long : counters_.malformed);
  size_ = 0;
  from_start_ = true;
}

void FrameParser::finish(double host_s, std::vector<Frame>& frames) {
  const std::size_t size = size_;
  const bool from_start = from_start_;
  size_ = 0;
  from_start_ = true;
  if (size == 0) return;  // an idle zero
  std::uint64_t* fault = &counters_.too_long;
  std::size_t decoded = 0;
  if (size <= kLongest) {
    decoded = wire::cobs_decode(encoded_.data(), size, encoded_.data());
    fault = judge({encoded_.data(), decoded});
  }
  if (fault != nullptr) {
    ++(from_start ? *fault : counters_.cut);
    return;
  }
  ++counters_.frames;
  Frame& frame = frames.emplace_back();
  frame.header = wire::read_header(encoded_.data());
  frame.host_s = host_s;
  frame.payload.fill(0);
  std::copy_n(encoded_.data() + wire::kHeaderSize, decoded - wire::kHeaderSize - wire::kCrcSize,
              frame.payload.data());
}

/// The counter of what is wrong with a decoded frame, or null where nothing is.
std::uint64_t* FrameParser::judge(std::span<const std::uint8_t> decoded) {
  constexpr std::size_t kAround = wire::kHeaderSize + wire::kCrcSize;
  if (decoded.size() < kAround || decoded.size() > wire::kMaxFrame) return &counters_.malformed;
  if (!wire::crc_holds(decoded.data(), decoded.size())) return &counters_.bad_crc;
  const wire::Header header = wire::read_header(decoded.data());
  if (header.version != wire::kProtocolVersion) return &counters_.other_version;
  const int payload = wire::payload_size(header.type);
  if (payload < 0 || !sent_by_devices(header.type)) return &counters_.unknown_type;
  if (decoded.size() != kAround + static_cast<std::size_t>(payload)) return &counters_.malformed;
  return nullptr;
}

}  // namespace searig::acquisition
