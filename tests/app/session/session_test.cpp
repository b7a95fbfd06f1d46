#include "app/session/session.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "acquisition/error.h"
#include "acquisition/recording/write_recording.h"
#include "tests/acquisition/clock/simulated_device.h"
#include "tests/temporary_folder.h"

namespace searig::app {
namespace {

using acquisition::Recording;

/// Both devices see the angle 0.3 sin(true time); the load cell as a force of 200 N per rad.
Recording turning(const acquisition::SimulatedPair& pair) {
  std::mt19937_64 random(1);
  Recording recording = pair.record(random);
  const auto truth = [](const acquisition::Stream& stream,
                        const acquisition::SimulatedDevice& device, double factor) {
    std::vector<double> values;
    for (const double t_s : stream.t_s)
      values.push_back(factor * std::sin((t_s - device.offset_s) / (1.0 + 1e-6 * device.ppm)));
    return values;
  };
  recording.module.channels = {{"input_angle_rad", truth(recording.module, pair.module, 0.5)},
                               {"output_angle_rad", truth(recording.module, pair.module, 0.2)}};
  recording.loadcell.channels = {{"force_n", truth(recording.loadcell, pair.loadcell, 60.0)}};
  recording.lever_arm_m = 0.15;
  recording.gear_ratio = 100.0;
  return recording;
}

TEST(Session, BringsDeflectionAndTorqueToOneClock) {
  acquisition::SimulatedPair pair;
  pair.module.offset_s = 300.0;
  pair.loadcell.offset_s = 20.0;
  pair.loadcell.ppm = -3000.0;
  const TemporaryFolder folder;
  acquisition::write_recording(turning(pair), folder.path());
  const Session session = open_session(folder.path());

  const estimator::Signals& signals = session.signals;
  ASSERT_EQ(signals.module.deflection_rad.size(), signals.module.t_s.size());
  ASSERT_EQ(signals.loadcell.torque_nm.size(), signals.loadcell.t_s.size());
  EXPECT_EQ(signals.gear_ratio, 100.0);
  EXPECT_EQ(signals.clock_ci95_s, session.clock.ci95_s);
  EXPECT_TRUE(signals.module.current_a.empty());
  for (std::size_t i = 0; i < signals.module.t_s.size(); ++i)
    ASSERT_NEAR(signals.module.deflection_rad[i], 0.3 * std::sin(signals.module.t_s[i] - 300.0),
                1e-9);
  for (std::size_t i = 0; i < signals.loadcell.t_s.size(); ++i)  // 9 Nm/s: 0.2 ms are 2 mNm
    ASSERT_NEAR(signals.loadcell.torque_nm[i], 9.0 * std::sin(signals.loadcell.t_s[i] - 300.0),
                2e-3);
}

TEST(Session, TimesRiseStrictlyThroughARestart) {
  acquisition::SimulatedPair pair;
  Recording recording = turning(pair);
  acquisition::Stream& cell = recording.loadcell;
  const std::size_t half = cell.t_s.size() / 2;
  for (std::size_t row = half; row < cell.t_s.size(); ++row) cell.t_s[row] -= 37.0;
  const TemporaryFolder folder;
  acquisition::write_recording(recording, folder.path());
  const Session session = open_session(folder.path());
  ASSERT_EQ(session.recording.loadcell.restarts, std::vector<std::size_t>{half});
  const estimator::LoadcellSignals& loadcell = session.signals.loadcell;
  ASSERT_EQ(loadcell.t_s.size(), cell.t_s.size());
  for (std::size_t i = 0; i < loadcell.t_s.size(); ++i) {
    ASSERT_NEAR(loadcell.torque_nm[i], 9.0 * std::sin(loadcell.t_s[i]), 5e-3);
    if (i > 0) {
      ASSERT_GT(loadcell.t_s[i], loadcell.t_s[i - 1]);
    }
  }
}

TEST(Session, FindsTheModelInTheRecordingUnlessToldAnother) {
  const TemporaryFolder folder;
  EXPECT_FALSE(find_model(folder.path(), std::nullopt));
  const char* text = "format = \"searig-model/1\"\n[spring.linear]\nk_nm_per_rad = ";
  folder.write("model.toml", std::string(text) + "40.0\n");
  const auto other = folder.write("other.toml", std::string(text) + "50.0\n");
  EXPECT_EQ(find_model(folder.path(), std::nullopt)->get("spring.linear", "k_nm_per_rad"), 40.0);
  EXPECT_EQ(find_model(folder.path(), other)->get("spring.linear", "k_nm_per_rad"), 50.0);
  EXPECT_THROW(find_model(folder.path(), folder.path() / "none.toml"), acquisition::InputError);
}

}  // namespace
}  // namespace searig::app
