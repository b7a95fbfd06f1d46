#include "acquisition/wire/encode.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "arduino/firmware/payloads.h"

namespace searig::acquisition {
namespace {

/// A host has no boot and no device time; it does not count what it asks.
std::vector<std::uint8_t> frame(wire::Type type, const std::uint8_t* payload, std::size_t size) {
  std::vector<std::uint8_t> bytes(wire::kMaxEncoded);
  const wire::Header header{wire::kProtocolVersion, type, 0, 0, 0};
  bytes.resize(wire::encode(header, payload, size, bytes.data()));
  return bytes;
}

template <typename Payload>
std::vector<std::uint8_t> frame_with(wire::Type type, const Payload& payload) {
  std::array<std::uint8_t, Payload::kSize> bytes;
  payload.write(bytes.data());
  return frame(type, bytes.data(), bytes.size());
}

}  // namespace

std::vector<std::uint8_t> ping_frame(std::uint32_t id, double host_s) {
  const auto sent_ns = static_cast<std::uint64_t>(std::llround(host_s * 1e9));
  return frame_with(wire::Type::ping, wire::PingPayload{id, 0, sent_ns});
}

std::vector<std::uint8_t> identify_frame() {
  return frame(wire::Type::identify, nullptr, 0);
}

std::vector<std::uint8_t> calibration_frame(std::int32_t tare_counts, float newton_per_count) {
  return frame_with(wire::Type::set_calibration,
                    wire::CalibrationPayload{tare_counts, newton_per_count});
}

std::vector<std::uint8_t> name_frame(std::string_view name) {
  std::array<std::uint8_t, wire::IdentityPayload::kNameSize> bytes{};
  std::copy_n(name.begin(), std::min(name.size(), bytes.size()), bytes.begin());
  return frame(wire::Type::set_name, bytes.data(), bytes.size());
}

}  // namespace searig::acquisition
