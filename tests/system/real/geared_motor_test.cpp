// A T-motor AK80-9 against a torque cell (neurobionics/TMotorCANControl): what current times a
// constant lacks. Another motor drives it backwards.
#include <algorithm>
#include <utility>

#include "tests/system/real/real_machine.h"

namespace searig {
namespace {

namespace fs = std::filesystem;

const fs::path kRecorded = kRealMachines / "gearmotor_torque_cell";

/// The cell's torque has the other sign than the motor's.
std::string mapping(const fs::path& file) {
  const std::string name = quoted(file);
  return "format = \"searig-recording/1\"\n[module]\nfile = " + name +
         "\ngear_ratio = 9.0\n[module.columns]\nt_s = { column = \"loop_time\" }\n"
         "current_a = { column = \"motor_measured_current\" }\n"
         "input_velocity_rad_s = { column = \"motor_measured_speed\" }\n[loadcell]\nfile = " +
         name +
         "\n[loadcell.columns]\nt_s = { column = \"loop_time\" }\n"
         "torque_nm = { column = \"adc_measured_torque\", scale = -1.0 }\n";
}

/// The driving motor logged its own angle, at 50:1, on a clock of its own, with the other sign.
std::string driving_motor(const fs::path& file, const std::string& aligned_by) {
  return "[device.driving_motor]\nfile = " + quoted(file) + "\naligned_by = \"" + aligned_by +
         "\"\n[device.driving_motor.columns]\nt_s = { column = 0 }\n"
         "input_angle_rad = { column = 1, scale = -0.02 }\n";
}

TEST(GearedMotor, LacksFrictionThatGrowsWithTheLoad) {
  if (!fs::exists(kRecorded)) GTEST_SKIP() << kRecorded << " is not there";
  for (const auto& [file, before_over_after] :
       {std::pair{"trial8.csv", 1.05}, std::pair{"system_id_test_2.csv", 1.05}}) {
    const TemporaryFolder folder;
    folder.write("recording.toml", mapping(kRecorded / file));
    const auto found = finding(diagnosed(folder.path().string()), "drive.load_friction");
    EXPECT_GT(found.at("probability"), 0.9) << file;
    // Its owners found 0.049 N*m/A; a motor gives 0.8 to 1.1 N*m/A.
    EXPECT_NEAR(parameter(found, "share"), 0.065, 0.035) << file;
    const auto& errors = found.at("heldout_rmse_nm");
    EXPECT_GT(double(errors.at("before")), before_over_after * double(errors.at("after"))) << file;
  }
}

TEST(GearedMotor, LacksFrictionThatADryJointHasToo) {
  if (!fs::exists(kRecorded)) GTEST_SKIP() << kRecorded << " is not there";
  const TemporaryFolder folder;
  folder.write("recording.toml", mapping(kRecorded / "system_id_test_2.csv"));
  const auto diagnosis = diagnosed(folder.path().string());
  EXPECT_TRUE(names_of(diagnosis).contains("drive.coulomb"));
  const auto& drive = diagnosis.at("paths").at("drive").at("heldout_rmse_nm");
  EXPECT_LT(double(drive.at("after")), 0.85 * double(drive.at("before")));
}

/// The second recording, whose angle is in a file of its own.
class DrivingMotor : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(kTrial)) GTEST_SKIP() << kTrial << " is not there";
    whole_.write("recording.toml", mapping(kTrial / "test-opposing-motor.csv") +
                                       driving_motor(kTrial / "log_mitry_dephy.csv", "velocity"));
  }

  nlohmann::json clock() const {
    const Ran ran = run_program("searig sync " + whole_.path().string() + " --json -");
    EXPECT_EQ(ran.exit_code, 0) << ran.err;
    return nlohmann::json::parse(ran.out).at("devices").at(0);
  }

  /// The rows between two moments, with the driving motor's angle already on the motor's clock.
  void write_part(const TemporaryFolder& folder, double from_s, double to_s) const {
    const auto map = clock().at("to_module");
    const auto log = columns_of(kTrial / "log_mitry_dephy.csv", false);
    std::ofstream angle(folder.path() / "angle.csv");
    angle.precision(12);
    for (std::size_t i = 0; i < log.at(0).size(); ++i)
      angle << double(map.at("rate")) * log[0][i] + double(map.at("offset_s")) << "," << log[1][i]
            << "\n";
    std::ifstream all(kTrial / "test-opposing-motor.csv");
    std::ofstream part(folder.path() / "part.csv");
    std::string line;
    std::getline(all, line);
    part << line << "\n";
    while (std::getline(all, line)) {
      const double t = std::atof(line.c_str());
      if (t >= from_s && t < to_s) part << line << "\n";
    }
    folder.write("recording.toml", mapping("part.csv") + driving_motor("angle.csv", "clock"));
  }

  const fs::path kTrial = kRecorded / "synchronized_trial_4";
  TemporaryFolder whole_;
};

TEST_F(DrivingMotor, StartedItsLogWhenTheMotorFeltIt) {
  const auto found = clock();
  EXPECT_TRUE(found.at("trusted")) << found.at("why");
  const auto& map = found.at("to_module");
  // By eye: the motor's speed jumps at 0.65 and 164.48 s, the log begins to move at 0.02 s and ends
  // at 163.84 s.
  EXPECT_NEAR(map.at("offset_s"), 0.64, 0.03);
  EXPECT_LT(map.at("ci95_s"), 0.1);
  EXPECT_NEAR(map.at("rate"), 1.0, 2e-4);
}

/// What the waves of a finding leave of the torque, N*m, before a constant is taken off.
std::vector<double> left_by(const nlohmann::json& ripple, const TemporaryFolder& folder) {
  const auto rows = columns_of(folder.path() / "part.csv", true);
  const auto log = columns_of(folder.path() / "angle.csv", false);
  std::vector<double> left;
  std::size_t j = 0;
  for (std::size_t i = 0; i < rows.at(0).size(); ++i) {
    while (j + 2 < log[0].size() && log[0][j + 1] < rows[0][i]) ++j;
    const double share = (rows[0][i] - log[0][j]) / (log[0][j + 1] - log[0][j]);
    const double q = -0.02 * (log[1][j] + share * (log[1][j + 1] - log[1][j]));
    double torque = -rows[2][i];
    for (const char* number : {"", "2", "3", "4"}) {
      const std::string n = number;
      const auto has = [&](const auto& p) { return p.at("name") == "torque" + n + "_nm"; };
      if (ripple.is_null() || std::ranges::none_of(ripple.at("parameters"), has)) continue;
      torque += parameter(ripple, "torque" + n + "_nm") *
                std::sin(parameter(ripple, "cycles" + n + "_per_rad") * q +
                         parameter(ripple, "phase" + n + "_rad"));
    }
    left.push_back(torque);
  }
  return left;
}

/// rms on the second half less the mean on the first: no number is from the second.
double shown(const nlohmann::json& ripple, const TemporaryFolder& first,
             const TemporaryFolder& second) {
  const double constant = mean(left_by(ripple, first));
  auto left = left_by(ripple, second);
  for (double& v : left) v -= constant;
  return rms(left);
}

TEST_F(DrivingMotor, RevealsARippleOverTheElectricalAngle) {
  const TemporaryFolder first, second;
  write_part(first, 1.2, 82.5);
  write_part(second, 82.5, 164.2);
  const auto diagnosis = diagnosed(first.path().string());
  const auto ripple = finding(diagnosis, "drive.ripple");
  EXPECT_GT(ripple.at("probability"), 0.95);
  EXPECT_TRUE(diagnosis.at("unexplained").is_null()) << diagnosis.at("unexplained");
  // 21 pole pairs behind 9:1: the electrical angle turns 189 times; its double is strongest.
  EXPECT_NEAR(parameter(ripple, "cycles_per_rad"), 2 * 189.0, 0.5);
  EXPECT_NEAR(parameter(ripple, "cycles2_per_rad"), 189.0, 0.5);
  EXPECT_NEAR(shown(nullptr, first, second), 0.395, 0.002);
  EXPECT_LT(shown(ripple, first, second), 0.225);
}

}  // namespace
}  // namespace searig
