#include "acquisition/wire/to_message.h"

#include <algorithm>

namespace searig::acquisition {
namespace {

/// Divided, not multiplied by 1e-6: so 1'500'000 is 1.5 to the last bit.
double micro(std::int32_t value) {
  return value == wire::kAbsent32 ? ModuleSample::kAbsent : static_cast<double>(value) / 1e6;
}

double centi(std::int16_t value) {
  return value == wire::kAbsent16 ? ModuleSample::kAbsent : static_cast<double>(value) / 1e2;
}

LoadcellSample loadcell_sample(const wire::LoadcellPayload& from, const Stamp& at) {
  LoadcellSample sample;
  sample.at = at;
  sample.counts = from.counts;
  sample.repeated = (from.flags & wire::LoadcellPayload::repeated) != 0;
  sample.at_limit = (from.flags & wire::LoadcellPayload::at_limit) != 0;
  sample.settling = (from.flags & wire::LoadcellPayload::settling) != 0;
  sample.overruns = from.overruns;
  sample.sent_s = at.device_s + from.age_us * 1e-6;
  return sample;
}

ModuleSample module_sample(const wire::ModulePayload& from, const Stamp& at) {
  ModuleSample sample;
  sample.at = at;
  sample.input_angle_rad = micro(from.input_angle_urad);
  sample.output_angle_rad = micro(from.output_angle_urad);
  sample.current_a = micro(from.current_ua);
  sample.commanded_angle_rad = micro(from.commanded_angle_urad);
  sample.input_velocity_rad_s = micro(from.input_velocity_urad_s);
  sample.winding_temperature_c = centi(from.winding_temperature_cc);
  sample.spring_temperature_c = centi(from.spring_temperature_cc);
  sample.overruns = from.overruns;
  return sample;
}

Identity identity(const wire::IdentityPayload& from, const Stamp& at) {
  Identity identity;
  identity.at = at;
  identity.kind = static_cast<Identity::Kind>(from.kind);
  identity.firmware_version = from.firmware_version;
  identity.rate_hz = from.rate_mhz / 1e3;
  const char* const end = from.name + wire::IdentityPayload::kNameSize;
  identity.name.assign(from.name, std::find(from.name, end, '\0'));
  identity.tare_counts = from.tare_counts;
  identity.newton_per_count = static_cast<double>(from.newton_per_count);
  identity.gear_ratio = static_cast<double>(from.gear_ratio);
  return identity;
}

Pong pong(const wire::PingPayload& from, const Stamp& at, const UnwrappedTime& time) {
  const auto received_us = static_cast<double>(time.at(from.received_us, at.host_s));
  return {at, from.id, static_cast<double>(from.host_sent_ns) / 1e9, received_us * 1e-6};
}

}  // namespace

Message to_message(const Frame& frame, const Stamp& at, const UnwrappedTime& time) {
  const std::uint8_t* const payload = frame.payload.data();
  switch (frame.header.type) {
    case wire::Type::module_sample:
      return module_sample(wire::ModulePayload::read(payload), at);
    case wire::Type::identity:
      return identity(wire::IdentityPayload::read(payload), at);
    case wire::Type::pong:
      return pong(wire::PingPayload::read(payload), at, time);
    default:
      return loadcell_sample(wire::LoadcellPayload::read(payload), at);
  }
}

}  // namespace searig::acquisition
