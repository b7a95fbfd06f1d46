#include "acquisition/recording/hebilog/channels.h"

#include <algorithm>
#include <array>

namespace searig::acquisition::hebilog {
namespace {

struct Named {
  Path path;
  const char* channel;
};

constexpr auto channels = std::to_array<Named>({
    {"10.9.1"_path, "commanded_angle_rad"},
    {"10.9.2"_path, "commanded_velocity_rad_s"},
    {"10.9.3"_path, "commanded_effort_nm"},
    {"11.1.2"_path, "led_red"},
    {"11.1.3"_path, "led_green"},
    {"11.1.4"_path, "led_blue"},
    {"11.3"_path, "voltage_v"},
    {"11.4"_path, "board_temperature_c"},
    {"11.6.2"_path, "accelerometer_x_m_s2"},
    {"11.6.3"_path, "accelerometer_y_m_s2"},
    {"11.6.4"_path, "accelerometer_z_m_s2"},
    {"11.7.2"_path, "gyro_x_rad_s"},
    {"11.7.3"_path, "gyro_y_rad_s"},
    {"11.7.4"_path, "gyro_z_rad_s"},
    {"11.9.1"_path, "output_angle_rad"},
    {"11.9.2"_path, "output_velocity_rad_s"},
    {"11.9.3"_path, "effort_nm"},
    {deflection, "deflection_rad"},
    {"11.9.5"_path, "motor_velocity_rad_s"},
    {"11.9.6"_path, "deflection_velocity_rad_s"},
    {"11.9.7"_path, "supply_current_a"},
    {"11.9.8"_path, "motor_sensor_temperature_c"},
    {"11.9.9"_path, "housing_temperature_c"},
    {"11.9.10"_path, "winding_temperature_c"},
    {"11.9.11"_path, "current_a"},
    {"11.9.12.1"_path, "output_turns"},
    {"11.9.12.2"_path, "output_angle_in_turn_rad"},
    {"11.9.13.1"_path, "motor_turns"},
    {"11.9.13.2"_path, "motor_angle_in_turn_rad"},
    {"11.11.1"_path, "orientation_w"},
    {"11.11.2"_path, "orientation_x"},
    {"11.11.3"_path, "orientation_y"},
    {"11.11.4"_path, "orientation_z"},
});

constexpr auto messages =
    std::to_array<Path>({"8"_path, "10"_path, "10.9"_path, "11"_path, "11.1"_path, "11.6"_path,
                         "11.7"_path, "11.9"_path, "11.9.12"_path, "11.9.13"_path, "11.10"_path,
                         "11.11"_path, "14"_path, "20"_path, "20.1"_path, "1012"_path});

constexpr auto no_channels = std::to_array<Path>(
    {module_id, hardware_received_us, hardware_sent_us, host_sent_us, sequence});

Path outermost(Path path, int levels) {
  while (path >> (12 * levels) != 0) path >>= 12;
  return path;
}

}  // namespace

bool is_message(Path path) {
  if (outermost(path, 2) == "11.10"_path) return true;  // pins of the I/O board, two levels more
  return std::ranges::find(messages, path) != messages.end();
}

std::optional<std::string> channel_of(Path path) {
  if (std::ranges::find(no_channels, path) != no_channels.end()) return std::nullopt;
  const auto known = std::ranges::find(channels, path, &Named::path);
  if (known != channels.end()) return known->channel;
  std::string channel = "field_" + text_of(path);
  std::ranges::replace(channel, '.', '_');
  return channel;
}

bool is_command(Path path) {
  return outermost(path, 1) == "10"_path;
}

}  // namespace searig::acquisition::hebilog
