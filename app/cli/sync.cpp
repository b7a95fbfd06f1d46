// searig sync: the load cell's clock held against the module's.
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "acquisition/clock/synchronise.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/session/stream_facts.h"
#include "app/session/sync_report.h"

namespace searig::app {
namespace {

struct Options {
  std::string recording;
  std::string json;
};

using acquisition::ClockMap;
using acquisition::Recording;

void say_map(const ClockMap& map, const std::string& short_name, const std::string& whose) {
  std::printf("module time = %.9f * %s time %+.6f s, +- %.2f ms (95 %%)\n", map.rate,
              short_name.c_str(), map.offset_s, 1e3 * map.ci95_s);
  std::printf("%s clock runs %+.1f ppm against the module's\n", whose.c_str(),
              1e6 * (1.0 / map.rate - 1.0));
  std::printf("%s: %s\n", map.trusted ? "trusted" : "NOT TRUSTED", map.why.c_str());
}

void say(const Recording& recording, const ClockMap& map, const std::vector<ClockMap>& devices) {
  say_map(map, "load-cell", "the load cell's");
  for (std::size_t i = 0; i < devices.size(); ++i) {
    const std::string& name = recording.devices[i].stream.name;
    say_map(devices[i], name, name + "'s");
  }
  std::cout << stream_line(recording.module) << '\n' << stream_line(recording.loadcell) << '\n';
  for (const auto& device : recording.devices) std::cout << stream_line(device.stream) << '\n';
  if (!recording.cut_off.empty()) std::cout << recording.cut_off << '\n';
}

void run(const Options& options) {
  const Recording recording = acquisition::read_recording(options.recording);
  const ClockMap map = acquisition::synchronise(recording);
  std::vector<ClockMap> devices;
  for (const auto& device : recording.devices)
    devices.push_back(acquisition::synchronise(recording, device));
  give(
      options.json, [&] { say(recording, map, devices); },
      [&] { return sync_report(recording, map, devices); });
}

}  // namespace

void add_sync(CLI::App& app) {
  auto* command = app.add_subcommand("sync", "Hold the load cell's clock against the module's");
  const auto options = std::make_shared<Options>();
  command->add_option("RECORDING", options->recording, "A folder with a recording.toml, or .mcap")
      ->required();
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer("Example:\n  searig sync my_recording --json sync.json");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
