// A recording that is streamed gives what the loaded one gives, to the bit.
#include "app/session/evaluate_recording.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>
#include <string>

#include "acquisition/recorder/output_file.h"
#include "acquisition/recording/mcap/import.h"
#include "app/session/session.h"
#include "tests/acquisition/recording/refusal.h"
#include "tests/temporary_folder.h"

namespace searig::app {
namespace {

namespace fs = std::filesystem;

constexpr const char* model_text = R"(format = "searig-model/1"
[spring.linear]
k_nm_per_rad = 45.0
[drive.motor]
torque_constant_nm_per_a = 2.0
efficiency = 1.0
[drive.inertia]
j_kg_m2 = 0.01
[drive.coulomb]
torque_nm = 0.1
smoothing_rad_s = 0.01
)";

struct Made {
  bool two_clocks = false;
  bool deflection = true;   ///< else the two angles only
  std::string spoilt = "";  ///< a row in the middle of module.csv
  std::string model = "";
};

/// 30 s of a module at 1 kHz and a load cell at 80 Hz.
fs::path write(const TemporaryFolder& folder, const Made& made) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise;
  std::exponential_distribution<double> wait(4000.0);
  std::string module = "t_s", loadcell = "t_s";
  if (made.two_clocks) module += ",host_s", loadcell += ",host_s";
  module += ",input_angle_rad,output_angle_rad,current_a";
  module += made.deflection ? ",deflection_rad\n" : "\n";
  loadcell += ",force_n\n";
  const auto number = [](double x) { return "," + std::to_string(x); };
  for (int i = 0; i < 30000; ++i) {
    const double t = 0.001 * i, theta = 0.1 * std::sin(3 * t) + 0.03 * std::sin(11 * t);
    const double in = theta + 0.2 * std::sin(t) + 1e-5 * noise(random);
    if (i == 20000) module += made.spoilt;
    module += std::to_string(t);
    if (made.two_clocks) module += number(100 + t + 0.001 + wait(random));
    module += number(in) + number(0.2 * std::sin(t)) + number(20 * theta + 0.01 * noise(random));
    module += made.deflection ? number(theta) + "\n" : "\n";
  }
  for (int i = 0; i < 2400; ++i) {
    const double t = i / 80.0, theta = 0.1 * std::sin(3 * t) + 0.03 * std::sin(11 * t);
    loadcell += std::to_string(t + (made.two_clocks ? 7 : 0));
    if (made.two_clocks) loadcell += number(100 + t + 0.001 + wait(random));
    loadcell += number(400 * theta + 0.1 * noise(random)) + "\n";
  }
  folder.write("module.csv", module);
  folder.write("loadcell.csv", loadcell);
  if (!made.model.empty()) folder.write("model.toml", made.model);
  folder.write("recording.toml",
               "format = \"searig-recording/1\"\n[module]\nfile = \"module.csv\"\n[loadcell]\nfile "
               "= \"loadcell.csv\"\nlever_arm_m = 0.1\n");
  return folder.path();
}

fs::path as_mcap(const TemporaryFolder& folder, const fs::path& recording) {
  const fs::path file = folder.path() / "recording.mcap";
  auto read = acquisition::read_recording(recording);
  acquisition::OutputFile out(file);
  acquisition::mcap::write_mcap(read, acquisition::mcap::originals_of(read), "test",
                                [&](std::string_view bytes) { out.append(bytes); });
  return file;
}

std::string shown(const estimator::Evaluation& e) {
  char text[600];
  std::snprintf(text, sizeof text, "%a | %a %a %a %a | %a %a %a %a %a | %a %a %a %a", e.seconds,
                e.best_fit->k_nm_per_rad, e.best_fit->offset_nm, e.best_fit->score.error_percent,
                e.best_fit->score.rmse_nm, e.online->initial_k_nm_per_rad, e.online->k_nm_per_rad,
                e.online->score.error_percent, e.online->trust_weight_s,
                e.online->convergence ? e.online->convergence->after_s : -1.0,
                e.current->gain_nm_per_a, e.current->offset_nm, e.current->score.error_percent,
                e.current->score.rmse_nm);
  return text + e.drive_from;
}

/// Streams it, if it should be, and holds it against the loaded one.
void expect_same(const fs::path& recording, bool streamed) {
  const EvaluatedRecording found = evaluate_recording(recording, {}, {});
  EXPECT_EQ(found.streamed, streamed) << recording;
  const EvaluatedRecording ahead = evaluate_recording(recording, {}, {}, true);
  EXPECT_EQ(shown(ahead.evaluation), shown(found.evaluation));
  const Session session = open_session(recording);
  const auto whole = evaluate_session(session, find_model(recording, {}));
  EXPECT_EQ(shown(found.evaluation), shown(whole));
  auto notes = whole.notes;
  if (!session.recording.cut_off.empty()) notes.push_back(session.recording.cut_off);
  if (!session.clock.trusted)
    notes.push_back("the clocks are not to be trusted: " + session.clock.why);
  EXPECT_EQ(found.notes, notes);
}

TEST(EvaluateRecording, StreamsAFolderOnOneClock) {
  const TemporaryFolder folder;
  expect_same(write(folder, {}), true);
}

TEST(EvaluateRecording, StreamsAFolderOnTwoClocks) {
  const TemporaryFolder folder;
  expect_same(write(folder, {.two_clocks = true, .model = model_text}), true);
}

TEST(EvaluateRecording, StreamsAnMcapFile) {
  for (const bool two_clocks : {false, true}) {
    const TemporaryFolder folder;
    expect_same(as_mcap(folder, write(folder, {two_clocks, true, "", model_text})), true);
  }
}

TEST(EvaluateRecording, StreamsWhatHasTheAnglesOnly) {
  const TemporaryFolder folder;
  const fs::path recording = write(folder, {.deflection = false});
  expect_same(recording, true);
  expect_same(as_mcap(folder, recording), true);
}

TEST(EvaluateRecording, StreamsAFileUpToWhereItIsCutOff) {
  const TemporaryFolder folder;
  const fs::path file = as_mcap(folder, write(folder, {.two_clocks = true}));
  fs::resize_file(file, fs::file_size(file) / 3);
  expect_same(file, true);
}

TEST(EvaluateRecording, LoadsWhatSomethingBefell) {
  for (const char* row : {"0.5,0.1,0.1,1,0.01\n", "torn\n", "20,0,0,1\n"}) {
    const TemporaryFolder folder;
    expect_same(write(folder, {.spoilt = row}), false);
  }
}

TEST(EvaluateRecording, SaysOfABadRecordingWhatLoadingSays) {
  const TemporaryFolder folder;
  const fs::path recording = write(folder, {.spoilt = "19.9995,0,abc,1,0.01\n"});
  const std::string why = acquisition::refusal([&] { evaluate_recording(recording, {}, {}); });
  EXPECT_EQ(why, acquisition::refusal([&] { open_session(recording); }));
  EXPECT_TRUE(acquisition::says(why, "module.csv, line 20002, column output_angle_rad")) << why;
}

}  // namespace
}  // namespace searig::app
