#include "app/session/stream_facts.h"

#include <algorithm>
#include <cstdio>

#include "acquisition/clock/host_clock.h"

namespace searig::app {

using acquisition::Stream;

double seconds_of(const Stream& stream) {
  double seconds = 0.0;
  if (stream.t_s.empty()) return seconds;
  for (const acquisition::Run& run : acquisition::runs_of(stream))
    seconds += stream.t_s[run.last - 1] - stream.t_s[run.first];
  return seconds;
}

double rate_hz(const Stream& stream) {
  const double steps = static_cast<double>(stream.t_s.size() + stream.counts.lost) -
                       static_cast<double>(stream.restarts.size() + 1);
  const double seconds = seconds_of(stream);
  return seconds > 0.0 ? steps / seconds : 0.0;
}

nlohmann::json stream_json(const Stream& stream) {
  const acquisition::StreamCounts& counts = stream.counts;
  return {{"name", stream.name},
          {"received", counts.received},
          {"lost", counts.lost},
          {"doubled", counts.doubled},
          {"garbled", counts.garbled},
          {"out_of_order", counts.out_of_order},
          {"restarts", stream.restarts.size()},
          {"rate_hz", rate_hz(stream)}};
}

std::string stream_line(const Stream& stream) {
  const acquisition::StreamCounts& counts = stream.counts;
  char line[200];
  std::snprintf(line, sizeof line,
                "%-9s %8zu rows  %8.1f s  %7.1f Hz   lost %zu, doubled %zu, garbled %zu, "
                "out of order %zu, restarts %zu",
                stream.name.c_str(), counts.received, seconds_of(stream), rate_hz(stream),
                counts.lost, counts.doubled, counts.garbled, counts.out_of_order,
                stream.restarts.size());
  return line;
}

std::vector<std::string> switched_off(const acquisition::Recording& recording) {
  const auto has = [&](const char* channel) {
    return !recording.module.channel(channel).empty() ||
           std::ranges::any_of(recording.devices, [&](const acquisition::Device& device) {
             return !device.stream.channel(channel).empty();
           });
  };
  std::vector<std::string> sentences;
  if (recording.loadcell.t_s.empty())
    sentences.push_back("no load cell: nothing to hold the module against.");
  if (!has("deflection_rad") && !(has("input_angle_rad") && has("output_angle_rad")))
    sentences.push_back("no deflection: nothing can be said of the spring.");
  if (!has("current_a")) sentences.push_back("no current_a: no torque from the motor current.");
  if (!has("input_angle_rad") && !has("input_velocity_rad_s"))
    sentences.push_back("no input angle or velocity: no drive model, friction or inertia.");
  if (!has("output_angle_rad"))
    sentences.push_back("no output_angle_rad: no gravity or inertia of the lever.");
  if (!has("winding_temperature_c") && !has("spring_temperature_c"))
    sentences.push_back("no temperatures: no effect of temperature.");
  return sentences;
}

}  // namespace searig::app
