#include "arduino/module/simulated_module.h"

#include <cmath>
#include <cstring>

namespace searig::module {
namespace {

constexpr std::uint16_t kVersion = 1;

std::int32_t micro(double value) {
  return static_cast<std::int32_t>(std::lround(value * 1e6));
}

}  // namespace

SimulatedModule::SimulatedModule(const ModuleSettings& settings)
    : settings_(settings), twin_(estimator::twin::Parameters{}, settings.seed) {}

double SimulatedModule::next_sample_s() const {
  return started_s_ + static_cast<double>(samples_ + 1) / (settings_.rate_hz * rate());
}

std::uint32_t SimulatedModule::device_us(double true_s) const {
  const double device_s = settings_.clock_s + (true_s - started_s_) * rate();
  return static_cast<std::uint32_t>(std::llround(device_s * 1e6) & 0xFFFFFFFFll);
}

template <typename Payload>
SimulatedModule::Bytes SimulatedModule::frame(wire::Type type, const Payload& payload,
                                              double true_s) {
  std::array<std::uint8_t, Payload::kSize> content;
  payload.write(content.data());
  const wire::Header header{wire::kProtocolVersion, type, settings_.boot,
                            sequences_[static_cast<std::size_t>(type)]++, device_us(true_s)};
  Bytes bytes(wire::kMaxEncoded);
  bytes.resize(wire::encode(header, content.data(), content.size(), bytes.data()));
  return bytes;
}

SimulatedModule::Bytes SimulatedModule::take_sample() {
  const double true_s = next_sample_s();
  ++samples_;
  twin_.advance_to(settings_.begin_s + true_s);
  const auto reading = twin_.read_module();
  wire::ModulePayload payload{};
  payload.input_angle_urad = micro(reading.input_angle_rad);
  payload.output_angle_urad = micro(reading.output_angle_rad);
  payload.current_ua = micro(reading.current_a);
  payload.commanded_angle_urad = micro(reading.commanded_angle_rad);
  payload.input_velocity_urad_s = wire::kAbsent32;
  payload.winding_temperature_cc = payload.spring_temperature_cc = wire::kAbsent16;
  return frame(wire::Type::module_sample, payload, true_s);
}

SimulatedModule::Bytes SimulatedModule::identity(double true_s) {
  wire::IdentityPayload payload{};
  payload.kind = wire::DeviceKind::module;
  payload.firmware_version = kVersion;
  payload.rate_mhz = static_cast<std::uint32_t>(std::lround(settings_.rate_hz * 1e3));
  std::memcpy(payload.name, "simulated module", wire::IdentityPayload::kNameSize);
  payload.gear_ratio = static_cast<float>(twin_.parameters().drive.gear_ratio);
  return frame(wire::Type::identity, payload, true_s);
}

SimulatedModule::Bytes SimulatedModule::answer(std::span<const std::uint8_t> bytes, double true_s) {
  Bytes whole(bytes.begin(), bytes.end());
  if (!whole.empty() && whole.back() == 0) whole.pop_back();
  whole.resize(wire::cobs_decode(whole.data(), whole.size(), whole.data()));
  if (!wire::crc_holds(whole.data(), whole.size())) return {};
  const wire::Header header = wire::read_header(whole.data());
  const int size = wire::payload_size(header.type);
  if (size < 0 || whole.size() != wire::kHeaderSize + wire::kCrcSize + std::size_t(size)) return {};
  if (header.type == wire::Type::identify) return identity(true_s);
  if (header.type != wire::Type::ping) return {};
  auto ping = wire::PingPayload::read(whole.data() + wire::kHeaderSize);
  ping.received_us = device_us(true_s);
  return frame(wire::Type::pong, ping, true_s);
}

void SimulatedModule::restart(double true_s) {
  started_s_ = true_s;
  samples_ = 0;
  settings_.clock_s = 0.0;
  ++settings_.boot;
  sequences_.fill(0);
}

}  // namespace searig::module
