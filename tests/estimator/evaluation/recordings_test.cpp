// The evaluation held against recordings of real machines and against simulated ones whose truth
// is known. Only tests read answers.json.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "app/session/session.h"
#include "estimator/evaluation/evaluation.h"
#include "tests/temporary_folder.h"

namespace searig::estimator {
namespace {

namespace fs = std::filesystem;
const fs::path shared = SEARIG_SHARED_DIR;

struct Practice {
  Signals signals;
  std::optional<Model> model;
  double k;

  explicit Practice(const std::string& name) {
    const auto answers = nlohmann::json::parse(std::ifstream(shared / "practice/answers.json"));
    k = answers.at(name).at("truth").at("spring.linear.k_nm_per_rad");
    const fs::path folder = shared / "practice/recordings" / name;
    signals = app::open_session(folder).signals;
    model = app::find_model(folder, std::nullopt);
  }
};

// Recordings in which nothing is concealed and the model's numbers are exact; springs of 30 to
// 1,500 N*m/rad.
TEST(PracticeRecordings, OnlineEndsAtTheTruthFromATenfoldWrongStart) {
  if (!fs::exists(shared / "practice")) GTEST_SKIP() << "no practice recordings in " << shared;
  for (const char* name : {"r001", "r007", "q000", "q005", "q014", "q025"}) {
    const Practice practice(name);
    for (const double factor : {0.1, 1.0, 10.0}) {
      const Evaluation result = evaluate(practice.signals, &*practice.model,
                                         {.initial_k_nm_per_rad = factor * practice.k});
      EXPECT_NEAR(result.best_fit->k_nm_per_rad / practice.k, 1, 0.005) << name;
      EXPECT_NEAR(result.online->k_nm_per_rad / practice.k, 1, 0.03) << name << " x" << factor;
      EXPECT_TRUE(result.online->convergence) << name << " x" << factor;
    }
  }
}

TEST(PracticeRecordings, OnlineEndsThereWithThePapersOwnNumbersToo) {
  if (!fs::exists(shared / "practice")) GTEST_SKIP() << "no practice recordings in " << shared;
  for (const char* name : {"r001", "r007"}) {
    const Practice practice(name);
    const Evaluation result =
        evaluate(practice.signals, &*practice.model,
                 {.initial_k_nm_per_rad = 10 * practice.k, .exactly_as_the_paper = true});
    EXPECT_NEAR(result.online->k_nm_per_rad / practice.k, 1, 0.03) << name;
  }
}

// With equation (2) alone, friction is taken for torque.
TEST(PracticeRecordings, PapersDriveEndsAFewPercentHigh) {
  if (!fs::exists(shared / "practice")) GTEST_SKIP() << "no practice recordings in " << shared;
  for (const char* name : {"r001", "r007"}) {
    const Practice practice(name);
    const double k = evaluate(practice.signals, &*practice.model, {.drive = DriveTerms::paper})
                         .online->k_nm_per_rad;
    EXPECT_GT(k / practice.k, 1.02) << name;
    EXPECT_LT(k / practice.k, 1.08) << name;
  }
}

Signals through_mapping(const fs::path& file, const std::string& columns) {
  const TemporaryFolder folder;
  folder.write("recording.toml", "format = \"searig-recording/1\"\n[module]\nfile = \"" +
                                     file.string() + "\"\n[loadcell]\nfile = \"" + file.string() +
                                     "\"\n" + columns);
  return app::open_session(folder.path()).signals;
}

// The author's own results: lines "number,spring,amplitude,stiffness"; three runs of spring 5 for
// each amplitude, the first of which is here.
double authors_stiffness(int amplitude) {
  std::ifstream file(shared / "data/sea_metal_spring/StiffnessResults.csv");
  for (std::string line; std::getline(file, line);) {
    std::istringstream fields(line);
    std::string number, spring, torque, stiffness;
    std::getline(fields, number, ',');
    std::getline(fields, spring, ',');
    std::getline(fields, torque, ',');
    std::getline(fields, stiffness, ',');
    if (spring == "5" && torque == std::to_string(amplitude)) return std::stod(stiffness);
  }
  return std::nan("");
}

TEST(MetalSpring, BestFitIsTheAuthorsStiffness) {
  const fs::path folder = shared / "data/sea_metal_spring/stiffness";
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  int files = 0;
  for (const auto& file : fs::directory_iterator(folder)) {
    const int amplitude = std::stoi(file.path().filename().string().substr(3));
    const Signals signals = through_mapping(file.path(), R"(
[module.columns]
t_s = { column = "time" }
deflection_rad = { column = "displacement", unit = "deg" }
current_a = { column = "torque_in", scale = 0.7179 }
[loadcell.columns]
t_s = { column = "time" }
torque_nm = { column = "torque_out" }
)");
    const Evaluation result = evaluate(signals);
    ASSERT_TRUE(result.best_fit) << file;
    EXPECT_NEAR(result.best_fit->k_nm_per_rad / authors_stiffness(amplitude), 1, 1e-6) << file;
    EXPECT_TRUE(result.online && result.current) << file;
    EXPECT_FALSE(result.drive_independent) << file;
    ++files;
  }
  EXPECT_EQ(files, 9);
}

TEST(GearmotorTorqueCell, HasMotorCurrentAlone) {
  const fs::path file = shared / "data/gearmotor_torque_cell/trial8.csv";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const Signals signals = through_mapping(file, R"(
[module.columns]
t_s = { column = "loop_time" }
current_a = { column = "motor_measured_current" }
input_velocity_rad_s = { column = "motor_measured_speed" }
[loadcell.columns]
t_s = { column = "loop_time" }
torque_nm = { column = "adc_measured_torque", scale = -1.0 }
)");
  const Evaluation result = evaluate(signals);
  EXPECT_TRUE(result.current && !result.best_fit && !result.online);
  EXPECT_NEAR(result.current->gain_nm_per_a, 1.09, 0.01);  // at the output of a 9:1 gear
  EXPECT_LT(result.current->score.error_percent, 16);
  EXPECT_NE(result.drive_from.find("fitted to the load cell"), std::string::npos);
}

}  // namespace
}  // namespace searig::estimator
