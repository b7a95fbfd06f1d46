// What a device says, in SI units, and when.
#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <variant>

namespace searig::acquisition {

/// Place and time of a message.
struct Stamp {
  double host_s = 0.0;         ///< arrival of the bytes that completed it
  double device_s = 0.0;       ///< device clock, wraps of 2^32 us undone; begins anew with each run
  std::uint32_t sequence = 0;  ///< counts the messages of its type since the device's start
  std::uint32_t run = 0;       ///< 0, 1, 2 ...: the device's starts as seen here
};

struct LoadcellSample {
  Stamp at;
  std::int32_t counts = 0;  ///< as converted; force = (counts - tare) * newton_per_count
  bool repeated = false;    ///< the converter had nothing new; device time is that of the reading
  bool at_limit = false;    ///< at an end of the converter's range
  bool settling = false;    ///< right after power-up
  std::uint16_t overruns = 0;  ///< the device's own count of frames it could not make or send
  double sent_s = 0.0;         ///< device time at which it was sent; clocks are held against this
};

/// A channel that the module lacks is NaN.
struct ModuleSample {
  static constexpr double kAbsent = std::numeric_limits<double>::quiet_NaN();
  Stamp at;
  double input_angle_rad = kAbsent;
  double output_angle_rad = kAbsent;
  double current_a = kAbsent;
  double commanded_angle_rad = kAbsent;
  double input_velocity_rad_s = kAbsent;
  double winding_temperature_c = kAbsent;
  double spring_temperature_c = kAbsent;
  std::uint16_t overruns = 0;
};

/// The four times of a two-way exchange.
struct Pong {
  Stamp at;  ///< at.device_s: answered; at.host_s: the answer was here
  std::uint32_t id = 0;
  double host_sent_s = 0.0;
  double device_received_s = 0.0;
};

struct Identity {
  enum class Kind : std::uint8_t { loadcell_hx711 = 1, loadcell_analogue = 2, module = 3 };
  Stamp at;
  Kind kind = Kind::loadcell_hx711;
  std::uint16_t firmware_version = 0;
  double rate_hz = 0.0;
  std::string name;
  std::int32_t tare_counts = 0;
  double newton_per_count = 0.0;  ///< 0 where it was never calibrated
  double gear_ratio = 0.0;        ///< 0 where there is no gear
};

/// The device began anew: its clock and its sequences too. Comes before the run's first message.
/// Or it only paused: its clock stood still while it was not heard, and both go on where they were.
/// That is a run of its own too, as the clock is another time behind the host's.
struct Restart {
  double host_s = 0.0;
  std::uint32_t run = 0;
  std::uint16_t boot = 0;  ///< the device's own number of this start
  bool paused = false;
};

using Message = std::variant<LoadcellSample, ModuleSample, Pong, Identity, Restart>;

}  // namespace searig::acquisition
