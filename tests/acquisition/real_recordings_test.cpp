// Recordings that others made on real machines, read through mappings.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "acquisition/clock/host_clock.h"
#include "acquisition/clock/synchronise.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition {
namespace {

namespace fs = std::filesystem;
const fs::path kData = fs::path(SEARIG_SHARED_DIR) / "data";

#define SKIP_WITHOUT(path) \
  if (!fs::exists(path)) GTEST_SKIP() << (path) << " is not there"

/// A recording whose streams are both mapped from files of kData.
Recording mapped(const fs::path& module_file, const std::string& module,
                 const fs::path& loadcell_file, const std::string& loadcell) {
  TemporaryFolder folder;
  folder.write("recording.toml", "format = \"searig-recording/1\"\n[module]\nfile = \"" +
                                     fs::absolute(module_file).string() + "\"\n[module.columns]\n" +
                                     module + "[loadcell]\nlever_arm_m = 0.105\nfile = \"" +
                                     fs::absolute(loadcell_file).string() +
                                     "\"\n[loadcell.columns]\n" + loadcell);
  return read_recording(folder.path());
}

TEST(HebiModule, HardwareClockRunsFifteenPpmFastAgainstTheHost) {
  const fs::path log = kData / "hebi_x5_log" / "DERIVED_exampleLog_decoded.csv";
  SKIP_WITHOUT(log);
  const Recording recording = mapped(log,
                                     "t_s = { column = \"hwB_us\", unit = \"us\" }\n"
                                     "host_s = { column = \"log_us\", unit = \"us\" }\n"
                                     "deflection_rad = { column = \"defl\" }\n",
                                     log,
                                     "t_s = { column = \"pcTx_us\", unit = \"us\" }\n"
                                     "host_s = { column = \"log_us\", unit = \"us\" }\n"
                                     "torque_nm = { column = \"effort\" }\n");
  EXPECT_FALSE(recording.one_clock);
  ASSERT_EQ(recording.module.t_s.size(), 1000u);
  const ClockMap map = synchronise(recording);
  EXPECT_TRUE(map.trusted) << map.why;
  EXPECT_NEAR(1e6 * std::abs(map.rate - 1.0), 15.0, 3.0);

  const std::vector<double>& pc_s = recording.loadcell.t_s;
  const std::vector<double>& module_s = recording.module.t_s;
  double mean = 0.0, square = 0.0;
  for (std::size_t row = 0; row < pc_s.size(); ++row) {
    const double apart = module_s[row] - map.to_module(pc_s[row]);
    mean += apart / 1000.0;
    square += apart * apart / 1000.0;
  }
  EXPECT_LT(std::sqrt(square - mean * mean), 0.0003);
  EXPECT_LT(std::abs(mean), map.ci95_s);
}

TEST(ArduinoLoadcell, EveryFaultOfAKnownWeightLogIsCounted) {
  const fs::path log = kData / "arduino_loadcell" / "20170712-loadcellTests_1.csv";
  SKIP_WITHOUT(log);
  const Recording recording =
      mapped(log,
             "t_s = { column = \"Time (ms)\", unit = \"ms\" }\n"
             "current_a = { column = \"EPOSCurrent ()\", unit = \"mA\", wraps_at = 65536 }\n",
             log,
             "t_s = { column = \"Time (ms)\", unit = \"ms\" }\n"
             "force_n = { column = \"LoadCell ()\", unit = \"g\" }\n");
  // Of 4528 rows the first five are left in the buffer from the run before (136.843, 136.893,
  // 136.793, 136.843, 136.893 s); then the Arduino restarts at 0.320 s.
  const Stream& loadcell = recording.loadcell;
  EXPECT_EQ(loadcell.counts.received, 4526u);
  EXPECT_EQ(loadcell.counts.doubled, 2u);
  EXPECT_EQ(loadcell.counts.out_of_order, 1u);
  EXPECT_EQ(loadcell.counts.garbled, 0u);
  EXPECT_EQ(loadcell.restarts, std::vector<std::size_t>{3});
  EXPECT_EQ(loadcell.t_s[3], 0.320);
  for (const double current : recording.module.channel("current_a"))
    ASSERT_LT(std::abs(current), 5.0);
  const ClockMap map = synchronise(recording);
  ASSERT_EQ(map.loadcell_runs.size(), 1u);
  EXPECT_EQ(map.loadcell_runs[0].first, 3u);
}

TEST(ArduinoLoadcell, BootMessagesAndTornRowsOfARawLogAreCounted) {
  const fs::path log =
      kData / "arduino_loadcell" / "20170811-stepTorqueSoftware-i_005_b_20_k_100.csv";
  SKIP_WITHOUT(log);
  const Recording recording = mapped(
      log, "t_s = { column = 7, unit = \"ms\" }\ncurrent_a = { column = 5, unit = \"mA\" }\n", log,
      "t_s = { column = 7, unit = \"ms\" }\nforce_n = { column = 0, unit = \"g\" }\n");
  EXPECT_EQ(recording.module.counts.received + recording.module.counts.garbled, 296u);
  EXPECT_EQ(recording.module.counts.garbled, 139u);    // one field instead of eight
  EXPECT_EQ(recording.loadcell.counts.garbled, 140u);  // and one load-cell value is no number
}

TEST(GearmotorTorqueCell, ReadsRowsWithAFieldMoreThanTheHeader) {
  const fs::path log = kData / "gearmotor_torque_cell" / "trial8.csv";
  SKIP_WITHOUT(log);
  const Recording recording = mapped(
      log,
      "t_s = { column = \"loop_time\" }\ncurrent_a = { column = \"motor_measured_current\" }\n",
      log,
      "t_s = { column = \"loop_time\" }\ntorque_nm = { column = \"adc_measured_torque\", scale = "
      "-1 }\n");
  EXPECT_TRUE(recording.one_clock);
  EXPECT_EQ(recording.module.counts.garbled, 0u);
  EXPECT_EQ(recording.module.t_s.size(), recording.loadcell.t_s.size());
  EXPECT_EQ(recording.loadcell.channel("torque_nm")[0], 0.47661902287020574);
}

TEST(GearmotorTorqueCell, ReadsALogWithoutAHeaderByColumnNumber) {
  const fs::path trial = kData / "gearmotor_torque_cell" / "synchronized_trial_4";
  SKIP_WITHOUT(trial);
  const Recording recording = mapped(
      trial / "log_mitry_dephy.csv",
      "t_s = { column = 0 }\nmotor_angle_rad = { column = 1 }\ncurrent_a = { column = 1 }\n",
      trial / "test-opposing-motor.csv",
      "t_s = { column = \"loop_time\" }\ntorque_nm = { column = \"adc_measured_torque\" }\n");
  EXPECT_EQ(recording.module.channel("motor_angle_rad")[0], -0.022626222145293223);
  EXPECT_EQ(recording.module.counts.garbled, 0u);
}

TEST(MetalSpring, ReadsASoftwareLoopWithoutInventingLosses) {
  const fs::path file = kData / "sea_metal_spring" / "stiffness" / "kt-9-1-70-5-09032023-143520";
  SKIP_WITHOUT(file);
  const Recording recording =
      mapped(file,
             "t_s = { column = \"time\" }\ndeflection_rad = { column = \"displacement\", unit = "
             "\"deg\" }\n"
             "current_a = { column = \"torque_in\", scale = 0.7179 }\n",
             file, "t_s = { column = \"time\" }\ntorque_nm = { column = \"torque_out\" }\n");
  EXPECT_EQ(recording.module.t_s.size(), 14573u);
  EXPECT_EQ(recording.module.counts.lost, 0u);
  EXPECT_NEAR(recording.module.channel("deflection_rad")[0], -0.0017429999999998558 * M_PI / 180.0,
              1e-18);
}

}  // namespace
}  // namespace searig::acquisition
