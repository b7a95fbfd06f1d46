// How a recording lies in an MCAP file: its topics and what their messages hold.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace searig::acquisition::mcap {

inline constexpr std::string_view format_name = "searig-mcap/1";

inline constexpr const char* settings_topic = "/settings";  ///< once, the first message
inline constexpr const char* module_topic = "/module";      ///< a message for each sample
inline constexpr const char* loadcell_topic = "/loadcell";
inline constexpr const char* device_topics = "/device.";  ///< "/device.encoder": a further device
inline constexpr const char* raw_suffix = "/raw";         ///< "/module/raw": bytes as they came
inline constexpr const char* counters_suffix = "/counters";  ///< "/module/counters": each second
inline constexpr const char* pings_suffix = "/pings";        ///< "/module/pings": two-way exchanges
inline constexpr const char* events_topic = "/events";
inline constexpr const char* clock_topic = "/clock";  ///< each second: what was known live

// Message definitions as ROS 2 writes them. host_s is the host's monotonic clock, s.
inline constexpr const char* settings_definition = "string json\n";
inline constexpr const char* raw_definition = "float64 host_s\nuint8[] bytes\n";
inline constexpr const char* event_definition =
    "float64 host_s\nstring device\nstring kind\nstring text\n";

/// Samples, counters and clocks are rows of numbers: "float64 t_s\nfloat64 host_s\nfloat64
/// force_n\n".
std::string row_definition(const std::vector<std::string>& columns);

/// The columns of such a definition; empty where it is another.
std::vector<std::string> row_columns(std::string_view definition);

/// Seconds as MCAP counts time, held within what a uint64 can say.
std::uint64_t nanoseconds(double seconds);

}  // namespace searig::acquisition::mcap
