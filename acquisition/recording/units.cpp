#include "acquisition/recording/units.h"

#include <array>
#include <numbers>

namespace searig::acquisition {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kStandardGravity = 9.80665;  // m/s^2; a mass read as a force is its weight

constexpr auto kUnits = std::to_array<Unit>({
    {"s", "s", {}},
    {"ms", "s", {1e-3}},
    {"us", "s", {1e-6}},
    {"ns", "s", {1e-9}},
    {"min", "s", {60.0}},
    {"rad", "rad", {}},
    {"mrad", "rad", {1e-3}},
    {"deg", "rad", {kPi / 180.0}},
    {"turn", "rad", {2.0 * kPi}},
    {"rad/s", "rad/s", {}},
    {"deg/s", "rad/s", {kPi / 180.0}},
    {"rpm", "rad/s", {2.0 * kPi / 60.0}},
    {"A", "A", {}},
    {"mA", "A", {1e-3}},
    {"N", "N", {}},
    {"mN", "N", {1e-3}},
    {"kN", "N", {1e3}},
    {"g", "N", {kStandardGravity * 1e-3}},
    {"kg", "N", {kStandardGravity}},
    {"lbf", "N", {4.4482216152605}},
    {"Nm", "N*m", {}},
    {"N*m", "N*m", {}},
    {"mNm", "N*m", {1e-3}},
    {"mN*m", "N*m", {1e-3}},
    {"Nmm", "N*m", {1e-3}},
    {"N*mm", "N*m", {1e-3}},
    {"degC", "degC", {}},
    {"K", "degC", {1.0, -273.15}},
    {"degF", "degC", {5.0 / 9.0, -160.0 / 9.0}},
    {"1", "1", {}},
});

struct ChannelUnit {
  std::string_view channel, unit;
};

constexpr auto kChannels = std::to_array<ChannelUnit>({
    {"t_s", "s"},
    {"host_s", "s"},
    {"seq", "1"},
    {"input_angle_rad", "rad"},
    {"output_angle_rad", "rad"},
    {"deflection_rad", "rad"},
    {"motor_angle_rad", "rad"},
    {"commanded_angle_rad", "rad"},
    {"input_velocity_rad_s", "rad/s"},
    {"current_a", "A"},
    {"winding_temperature_c", "degC"},
    {"spring_temperature_c", "degC"},
    {"force_n", "N"},
    {"torque_nm", "N*m"},
});

/// The longer ones first.
constexpr auto kEndings = std::to_array<ChannelUnit>({
    {"_rad_s", "rad/s"},
    {"_m_s2", "m/s^2"},
    {"_rad", "rad"},
    {"_nm", "N*m"},
    {"_s", "s"},
    {"_n", "N"},
    {"_a", "A"},
    {"_v", "V"},
    {"_c", "degC"},
});

}  // namespace

std::optional<Unit> find_unit(std::string_view name) {
  for (const Unit& unit : kUnits)
    if (unit.name == name) return unit;
  return std::nullopt;
}

std::optional<std::string_view> channel_unit(std::string_view channel) {
  for (const ChannelUnit& known : kChannels)
    if (known.channel == channel) return known.unit;
  return std::nullopt;
}

std::string_view unit_of(std::string_view channel) {
  if (const auto unit = channel_unit(channel)) return *unit;
  for (const ChannelUnit& ending : kEndings)
    if (channel.ends_with(ending.channel)) return ending.unit;
  return "1";
}

std::string units_like(std::string_view si_unit) {
  std::string names;
  for (const Unit& unit : kUnits)
    if (unit.measures == si_unit) names.append(names.empty() ? "" : ", ").append(unit.name);
  return names;
}

}  // namespace searig::acquisition
