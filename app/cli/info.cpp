// searig info: what is in a recording.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <memory>

#include "acquisition/clock/synchronise.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/session/stream_facts.h"

namespace searig::app {
namespace {

struct Options {
  std::string recording;
  std::string json;
};

nlohmann::json stream_answer(const acquisition::Stream& stream) {
  nlohmann::json answer = stream_json(stream);
  answer["file"] = stream.file.string();
  answer["seconds"] = seconds_of(stream);
  answer["host_stamps"] = !stream.host_s.empty();
  answer["channels"] = nlohmann::json::array();
  for (const acquisition::Channel& channel : stream.channels) {
    const auto [low, high] = std::minmax_element(channel.values.begin(), channel.values.end());
    answer["channels"].push_back({{"name", channel.name}, {"lowest", *low}, {"highest", *high}});
  }
  return answer;
}

double first_arrival_s(const acquisition::Recording& recording) {
  double first = std::numeric_limits<double>::infinity();
  for (const acquisition::Stream* stream : {&recording.module, &recording.loadcell})
    for (const double host_s : stream->host_s) first = std::min(first, host_s);
  return std::isfinite(first) ? first : 0.0;
}

nlohmann::json events_answer(const acquisition::Recording& recording) {
  nlohmann::json events = nlohmann::json::array();
  const double start_s = first_arrival_s(recording);
  for (const acquisition::Event& event : recording.events)
    events.push_back({{"at_s", event.host_s - start_s},
                      {"device", event.device},
                      {"kind", event.kind},
                      {"text", event.text}});
  return events;
}

nlohmann::json answer(const acquisition::Recording& recording, const acquisition::ClockMap& map) {
  nlohmann::json out{
      {"format", "searig-info/1"},
      {"name", recording.name},
      {"gear_ratio", recording.gear_ratio},
      {"lever_arm_m", recording.lever_arm_m},
      {"one_clock", recording.one_clock},
      {"clocks_trusted", map.trusted},
      {"clocks_why", map.why},
      {"streams", {stream_answer(recording.module), stream_answer(recording.loadcell)}},
      {"recorded", recording.recorded},
      {"events", events_answer(recording)},
      {"cut_off", recording.cut_off},
      {"switched_off", switched_off(recording)}};
  for (const auto& device : recording.devices)
    out["streams"].push_back(stream_answer(device.stream));
  return out;
}

void say_stream(const acquisition::Stream& stream) {
  std::cout << stream_line(stream) << "\n    " << stream.file.string() << '\n';
  for (const acquisition::Channel& channel : stream.channels) {
    const auto [low, high] = std::minmax_element(channel.values.begin(), channel.values.end());
    char line[120];
    std::snprintf(line, sizeof line, "    %-22s %12.6g to %.6g\n", channel.name.c_str(), *low,
                  *high);
    std::cout << line;
  }
}

/// Each event on the host's clock, counted from the first arrival.
void say_events(const acquisition::Recording& recording) {
  if (!recording.recorded.empty()) std::cout << recording.recorded << '\n';
  const double start_s = first_arrival_s(recording);
  for (const acquisition::Event& event : recording.events)
    std::printf("%10.3f s  %-9s %-12s %s\n", event.host_s - start_s, event.device.c_str(),
                event.kind.c_str(), event.text.c_str());
}

void say(const acquisition::Recording& recording, const acquisition::ClockMap& map) {
  std::cout << recording.name << ": gear ratio " << recording.gear_ratio << ", lever arm "
            << recording.lever_arm_m << " m\n";
  say_stream(recording.module);
  say_stream(recording.loadcell);
  for (const auto& device : recording.devices) say_stream(device.stream);
  std::cout << "clocks: " << (map.trusted ? "" : "NOT TRUSTED: ") << map.why << '\n';
  say_events(recording);
  if (!recording.cut_off.empty())
    std::cout << recording.cut_off << " searig recover makes a whole file of it.\n";
  for (const std::string& sentence : switched_off(recording)) std::cout << sentence << '\n';
}

void run(const Options& options) {
  const acquisition::Recording recording = acquisition::read_recording(options.recording);
  const acquisition::ClockMap map = acquisition::synchronise(recording);
  give(
      options.json, [&] { say(recording, map); }, [&] { return answer(recording, map); });
}

}  // namespace

void add_info(CLI::App& app) {
  auto* command = app.add_subcommand("info", "Say what is in a recording");
  const auto options = std::make_shared<Options>();
  command->add_option("RECORDING", options->recording, "A folder with a recording.toml, or .mcap")
      ->required();
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer("Example:\n  searig info my_recording");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
