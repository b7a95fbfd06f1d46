// What the frames carry: one struct per type, with its size on the wire and its way there and back.
#pragma once

#include "frame.h"

namespace searig {
namespace wire {

/// One reading of the load cell; the header's time is when it was taken.
struct LoadcellPayload {
  static const size_t kSize = 9;
  enum Flag : uint8_t {
    repeated = 1,  // no newer reading since the last frame: the converter is slower than the frames
    at_limit = 2,  // at an end of the converter's range
    settling = 4   // of the first readings after power-up
  };
  int32_t counts;  // as converted, tare and gain not applied
  uint8_t flags;
  uint16_t overruns;  // frames this device could not make or send since its start
  // From the reading to the frame's sending, us, 65535 where longer. The host's clock is held
  // against the sending, as the wait before it varies by a whole conversion.
  uint16_t age_us;

  void write(uint8_t* to) const {
    Writer put(to);
    put.i32(counts), put.u8(flags), put.u16(overruns), put.u16(age_us);
  }
  static LoadcellPayload read(const uint8_t* from) {
    Reader get(from);
    LoadcellPayload v;
    v.counts = get.i32(), v.flags = get.u8(), v.overruns = get.u16(), v.age_us = get.u16();
    return v;
  }
};

const int32_t kAbsent32 = INT32_MIN;  // a channel that this module does not have
const int16_t kAbsent16 = INT16_MIN;

/// One reading of an actuator module. Angles behind the gear train, before and after the spring.
struct ModulePayload {
  static const size_t kSize = 26;
  int32_t input_angle_urad;
  int32_t output_angle_urad;
  int32_t current_ua;
  int32_t commanded_angle_urad;
  int32_t input_velocity_urad_s;
  int16_t winding_temperature_cc;  // hundredths of a degree Celsius
  int16_t spring_temperature_cc;
  uint16_t overruns;

  void write(uint8_t* to) const {
    Writer put(to);
    put.i32(input_angle_urad), put.i32(output_angle_urad), put.i32(current_ua);
    put.i32(commanded_angle_urad), put.i32(input_velocity_urad_s);
    put.i16(winding_temperature_cc), put.i16(spring_temperature_cc), put.u16(overruns);
  }
  static ModulePayload read(const uint8_t* from) {
    Reader get(from);
    ModulePayload v;
    v.input_angle_urad = get.i32(), v.output_angle_urad = get.i32(), v.current_ua = get.i32();
    v.commanded_angle_urad = get.i32(), v.input_velocity_urad_s = get.i32();
    v.winding_temperature_cc = get.i16(), v.spring_temperature_cc = get.i16();
    v.overruns = get.u16();
    return v;
  }
};

enum class DeviceKind : uint8_t { loadcell_hx711 = 1, loadcell_analogue = 2, module = 3 };

/// Sent at the start, when asked, and after a setting was stored.
struct IdentityPayload {
  static const size_t kNameSize = 16;
  static const size_t kSize = 35;
  DeviceKind kind;
  uint16_t firmware_version;
  uint32_t rate_mhz;       // samples in 1000 s
  char name[kNameSize];    // padded with zeros
  int32_t tare_counts;     // force = (counts - tare) * newton_per_count
  float newton_per_count;  // 0 where it was never calibrated
  float gear_ratio;        // 0 where there is no gear

  void write(uint8_t* to) const {
    Writer put(to);
    put.u8(static_cast<uint8_t>(kind)), put.u16(firmware_version), put.u32(rate_mhz);
    put.text(name, kNameSize), put.i32(tare_counts);
    put.f32(newton_per_count), put.f32(gear_ratio);
  }
  static IdentityPayload read(const uint8_t* from) {
    Reader get(from);
    IdentityPayload v;
    v.kind = static_cast<DeviceKind>(get.u8());
    v.firmware_version = get.u16(), v.rate_mhz = get.u32();
    get.text(v.name, kNameSize), v.tare_counts = get.i32();
    v.newton_per_count = get.f32(), v.gear_ratio = get.f32();
    return v;
  }
};

/// Ping and pong are of one length, so that both ways take equally long on a serial line. The pong
/// gives back what the ping held; its header's time is when it was handed to the line. Thus the
/// device's bytes alone hold all four times of an exchange.
struct PingPayload {
  static const size_t kSize = 16;
  uint32_t id;
  uint32_t received_us;   // device time at which the ping was whole; 0 in a ping
  uint64_t host_sent_ns;  // host's monotonic clock

  void write(uint8_t* to) const {
    Writer put(to);
    put.u32(id), put.u32(received_us), put.u64(host_sent_ns);
  }
  static PingPayload read(const uint8_t* from) {
    Reader get(from);
    PingPayload v;
    v.id = get.u32(), v.received_us = get.u32(), v.host_sent_ns = get.u64();
    return v;
  }
};

/// Kept by the device over power-down, as is the name.
struct CalibrationPayload {
  static const size_t kSize = 8;
  int32_t tare_counts;
  float newton_per_count;

  void write(uint8_t* to) const {
    Writer put(to);
    put.i32(tare_counts), put.f32(newton_per_count);
  }
  static CalibrationPayload read(const uint8_t* from) {
    Reader get(from);
    CalibrationPayload v;
    v.tare_counts = get.i32(), v.newton_per_count = get.f32();
    return v;
  }
};

/// The payload's size, or -1 for a type that this version does not know.
inline int payload_size(Type type) {
  switch (type) {
    case Type::loadcell_sample:
      return LoadcellPayload::kSize;
    case Type::module_sample:
      return ModulePayload::kSize;
    case Type::identity:
      return IdentityPayload::kSize;
    case Type::pong:
    case Type::ping:
      return PingPayload::kSize;
    case Type::identify:
      return 0;
    case Type::set_calibration:
      return CalibrationPayload::kSize;
    case Type::set_name:
      return IdentityPayload::kNameSize;
  }
  return -1;
}

}  // namespace wire
}  // namespace searig
