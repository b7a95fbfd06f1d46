// What the host says to a device, as bytes for Source::send().
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace searig::acquisition {

/// Asks for a Pong. host_s: host_now_s() right before sending.
std::vector<std::uint8_t> ping_frame(std::uint32_t id, double host_s);

/// Asks for an Identity.
std::vector<std::uint8_t> identify_frame();

/// Stores a load cell's tare and gain in the device; it answers with its Identity.
std::vector<std::uint8_t> calibration_frame(std::int32_t tare_counts, float newton_per_count);

/// Stores the device's name, of which 16 bytes are kept; it answers with its Identity.
std::vector<std::uint8_t> name_frame(std::string_view name);

}  // namespace searig::acquisition
