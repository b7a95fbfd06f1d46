// searig sync: the load cell's clock held against the module's.
#include <iostream>
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

nlohmann::json answer(const acquisition::Recording& recording, const acquisition::ClockMap& map) {
  return {{"format", "searig-sync/1"},
          {"loadcell_to_module",
           {{"rate", map.rate}, {"offset_s", map.offset_s}, {"ci95_s", map.ci95_s}}},
          {"trusted", map.trusted},
          {"why", map.why},
          {"streams", {stream_json(recording.module), stream_json(recording.loadcell)}}};
}

void say(const acquisition::Recording& recording, const acquisition::ClockMap& map) {
  std::printf("module time = %.9f * load-cell time %+.6f s, +- %.2f ms (95 %%)\n", map.rate,
              map.offset_s, 1e3 * map.ci95_s);
  std::printf("the load cell's clock runs %+.1f ppm against the module's\n",
              1e6 * (1.0 / map.rate - 1.0));
  std::printf("%s: %s\n", map.trusted ? "trusted" : "NOT TRUSTED", map.why.c_str());
  std::cout << stream_line(recording.module) << '\n' << stream_line(recording.loadcell) << '\n';
  if (!recording.cut_off.empty()) std::cout << recording.cut_off << '\n';
}

void run(const Options& options) {
  const acquisition::Recording recording = acquisition::read_recording(options.recording);
  const acquisition::ClockMap map = acquisition::synchronise(recording);
  if (options.json != "-") say(recording, map);
  if (!options.json.empty()) write_json(answer(recording, map), options.json);
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
