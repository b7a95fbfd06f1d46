// searig record: a load cell and a module into one file, until the time is over or Ctrl-C.
#include <csignal>
#include <filesystem>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "acquisition/calibration/loadcell_calibration.h"
#include "acquisition/recorder/recorder.h"
#include "acquisition/recorder/wall_clock.h"
#include "acquisition/recording/text_file.h"
#include "app/cli/commands.h"
#include "app/cli/json_output.h"
#include "app/cli/progress_line.h"
#include "app/cli/record_answer.h"
#include "app/rig/simulated_devices.h"
#include "estimator/twin/parameters.h"

namespace searig::app {
namespace {

using acquisition::RecorderState;

struct Options {
  std::string loadcell, module, json;
  std::filesystem::path out;
  double seconds = std::numeric_limits<double>::infinity();
  std::optional<double> lever_arm_m;
  std::optional<std::string> calibration;
  double least_free_gb = 1.0;
};

// Ctrl-C and a closed terminal end a recording as its time does.
std::atomic<bool> stop{false};
extern "C" void stop_on_signal(int) {
  stop = true;
}

void end_on_signals() {
  struct sigaction action {};
  action.sa_handler = stop_on_signal;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  // A file that may not grow further is an error to be said, not a death.
  std::signal(SIGXFSZ, SIG_IGN);
}

acquisition::RecorderOptions recorder_options(const Options& options) {
  acquisition::RecorderOptions out;
  out.file.path = options.out;
  out.file.program = "searig " SEARIG_VERSION;
  out.file.epoch_s = acquisition::unix_now_s() - acquisition::host_now_s();
  out.file.least_free_bytes = static_cast<std::uint64_t>(1e9 * options.least_free_gb);
  out.seconds = options.seconds;
  out.started = acquisition::utc(acquisition::unix_now_s());
  out.lever_arm_m = options.lever_arm_m;
  if (options.calibration) {
    const std::string text = acquisition::read_text_file(*options.calibration);
    const auto calibration = acquisition::parse_calibration(text, *options.calibration);
    out.loadcell = {calibration.tare_counts, calibration.newton_per_count};
    out.calibration = text;
    if (!out.lever_arm_m) out.lever_arm_m = calibration.lever_arm_m;
  }
  if (!out.lever_arm_m && options.loadcell == simulated)
    out.lever_arm_m = estimator::twin::LeverParameters{}.arm_m;
  return out;
}

void run(const Options& options) {
  end_on_signals();
  SimulatedSources rig = open_rig(options.module, options.loadcell);
  acquisition::Recorder recorder(recorder_options(options), std::move(rig.module),
                                 std::move(rig.loadcell));
  RecorderState state;
  {
    ProgressLine line;
    state = recorder.run(stop, [&](const RecorderState& now) {
      line.say(state_line(now), std::isfinite(options.seconds) ? now.seconds / options.seconds
                                                               : ProgressLine::no_end);
    });
  }
  give(
      options.json, [&] { std::cout << options.out.string() << ": " << state_line(state) << '\n'; },
      [&] { return record_answer(options.out, state); });
}

}  // namespace

void add_record(CLI::App& app) {
  auto* command = app.add_subcommand("record", "Record a load cell and a module into one file");
  const auto options = std::make_shared<Options>();
  command
      ->add_option("--loadcell", options->loadcell,
                   "serial:DEVICE or its path, udp://HOST:PORT, or sim: for the simulated rig")
      ->required();
  command->add_option("--module", options->module, "udp://HOST:PORT, serial:DEVICE, or sim:")
      ->required();
  command->add_option("--out", options->out, "File to make (.mcap)")->required();
  command->add_option("--seconds", options->seconds, "How long (default: until Ctrl-C)")
      ->check(CLI::PositiveNumber);
  command
      ->add_option("--lever-arm", options->lever_arm_m,
                   "From the joint to the load cell, m; negative where it pulls the other way")
      ->check(CLI::Number);
  command->add_option("--calibration", options->calibration,
                      "The load cell's, from searig calibrate; else what it has stored itself");
  command
      ->add_option("--least-free-gb", options->least_free_gb,
                   "Stop, or do not begin, where the disk has less room (default 1)")
      ->check(CLI::NonNegativeNumber);
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->footer(
      "Example:\n  searig record --loadcell /dev/ttyACM0 --module udp://10.0.0.2:7777 "
      "--lever-arm 0.15 --out run.mcap\n  searig record --loadcell sim: --module sim: --seconds 10 "
      "--out sim.mcap");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
