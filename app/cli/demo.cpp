// searig demo: a whole calibration experiment on the simulated rig, from motion to report.
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>
#include <stdexcept>

#include "acquisition/error.h"
#include "acquisition/recording/mcap/read_mcap.h"
#include "app/cli/commands.h"
#include "app/cli/demo_report.h"
#include "app/cli/desktop_program.h"
#include "app/cli/json_output.h"
#include "app/report/diagnosis_report.h"
#include "app/report/diagnosis_sentences.h"
#include "app/rig/stepped_rig.h"
#include "app/session/session.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;

struct Options {
  double seconds = 60.0;
  fs::path out = "out";
  std::string json;
  bool headless = false;
};

/// Runs as fast as the machine allows.
void run_experiment(SteppedRig& rig, double seconds, DemoResult& result) {
  constexpr double step_s = 0.02;
  const bool say = isatty(STDERR_FILENO) != 0;
  const auto steps = static_cast<long>(seconds / step_s);
  for (long i = 1; i <= steps; ++i) {
    const double now_s = static_cast<double>(i) * step_s;
    rig.run_until(now_s);
    result.truth_t_s.push_back(now_s);
    result.truth_nm_per_rad.push_back(rig.true_stiffness_nm_per_rad());
    if (say && i % 500 == 0)
      std::cerr << "\r  " << i / 50 << " of " << seconds << " s" << std::flush;
  }
  if (say && steps >= 500) std::cerr << '\r';
  rig.finish();
}

/// Where the recording goes. An earlier demo's makes room for it; anybody else's does not.
fs::path place_for_recording(const fs::path& out) {
  const fs::path file = out / "recording.mcap";
  if (!fs::exists(file)) return file;
  if (!acquisition::mcap::read_settings(file).loadcell.source.starts_with("sim:"))
    throw acquisition::InputError(file.string() + ": is there already, and no demo has made it.");
  fs::remove(file);
  return file;
}

double clock_error_s(const Session& session, const acquisition::ClockMap& truth) {
  const auto& loadcell_s = session.recording.loadcell.t_s;
  const double middle_s = loadcell_s[loadcell_s.size() / 2];
  return session.clock.to_module(middle_s) - truth.to_module(middle_s);
}

/// The paper's Table I starts from a good stiffness, its figures 9 to 11 from a poor one; its drive
/// model has no friction, ours has.
void evaluate_all(const Session& session, const estimator::Model& model, DemoResult& result) {
  result.poor_start = estimator::evaluate(session.signals, &model);
  estimator::EvaluationOptions good;
  if (result.poor_start.best_fit) {
    good.initial_k_nm_per_rad = result.poor_start.best_fit->k_nm_per_rad;
  }
  result.good_start = estimator::evaluate(session.signals, &model, good);
  good.drive = estimator::DriveTerms::paper;
  result.bare_drive = estimator::evaluate(session.signals, &model, good);
}

/// The window as it looked live, and as it looks on the recording. Their absence is no failure: the
/// command line works without a GUI library.
std::vector<fs::path> take_pictures(const Options& options, const fs::path& recording) {
  std::vector<fs::path> pictures;
  const auto take = [&](const char* name, std::vector<std::string> arguments) {
    const fs::path picture = options.out / name;
    for (const char* more : {"--theme", "light", "--offscreen", "--screenshot"}) {
      arguments.emplace_back(more);
    }
    arguments.push_back(picture.string());
    if (run_to_end(find_desktop_program(), arguments) == 0) pictures.push_back(picture);
  };
  try {
    const double seconds = std::min(options.seconds, 20.0);
    take("desktop-live.png",
         {"--as-live", recording.string(), "--seconds", std::to_string(seconds)});
    take("desktop-recording.png", {recording.string()});
  } catch (const std::runtime_error& error) {
    std::cerr << "searig: no pictures of the window: " << error.what() << '\n';
  }
  return pictures;
}

void run(const Options& options) {
  const bool talk = options.json != "-";
  const auto say = [talk](const std::string& words) {
    if (talk) std::cout << words << '\n';
  };
  std::error_code error;
  fs::create_directories(options.out, error);
  if (error)
    throw std::runtime_error(options.out.string() + ": cannot be made: " + error.message() + ".");
  DemoResult result;
  result.recording = place_for_recording(options.out);
  SteppedRig rig(result.recording, "searig " SEARIG_VERSION);
  say("Simulated board running the firmware, load cell at 50 Hz, and a module at 500 Hz.");
  run_experiment(rig, options.seconds, result);
  say("Recording kept: " + result.recording.string());
  const Session session = open_session(result.recording);
  result.clock_error_s = clock_error_s(session, rig.true_clock_map());
  evaluate_all(session, rig.model(), result);
  for (const auto& line : describe(session, result)) say(line);

  // What the believed model leaves out of the simulated rig, as searig diagnose says it.
  const Examined examined = examine({&session}, rig.model());
  say(headline(examined.diagnosis));
  const fs::path diagnosis = options.out / "diagnosis.html";
  diagnosis_report(examined).write(diagnosis);

  result.report = options.out / "report.html";
  demo_report(session, rig, result).write(result.report);
  say("Reports: " + result.report.string() + " and " + diagnosis.string());
  result.pictures = take_pictures(options, result.recording);
  for (const auto& picture : result.pictures) say("Picture: " + picture.string());
  if (!options.json.empty()) write_json(to_json(session, result), options.json);

  if (has_display() && !options.headless) {
    say("Opening the window live on the simulated rig; close it to end.");
    become(find_desktop_program(), {"--live"});
  }
}

}  // namespace

void add_demo(CLI::App& app) {
  auto* command = app.add_subcommand("demo", "A whole calibration experiment on the simulated rig");
  const auto options = std::make_shared<Options>();
  command->add_option("--seconds", options->seconds, "How long the experiment is (default 60)")
      ->check(CLI::Range(5.0, 36000.0));
  command->add_option("--out", options->out, "Folder for recording, report and pictures (out)");
  command->add_option("--json", options->json, "Write the answer for machines (- for stdout)");
  command->add_flag("--headless", options->headless,
                    "Open no window even where there is a display");
  command->footer("Example:\n  searig demo --seconds 30 --out out");
  command->callback([options] { run(*options); });
}

}  // namespace searig::app
