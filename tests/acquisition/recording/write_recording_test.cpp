#include "acquisition/recording/write_recording.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/acquisition/clock/simulated_device.h"
#include "tests/temporary_folder.h"

namespace searig::acquisition {
namespace {

Recording small_recording() {
  std::mt19937_64 random(1);
  Recording recording = SimulatedPair{}.record(random);
  std::uniform_real_distribution<double> any(-1e3, 1e3);
  std::vector<double> values(recording.module.t_s.size());
  for (double& value : values) value = any(random);
  values[0] = std::numeric_limits<double>::denorm_min();
  recording.module.channels = {{"deflection_rad", values}, {"current_a", values}};
  recording.loadcell.channels.push_back(
      {"force_n", std::vector<double>(recording.loadcell.t_s.size(), 1.0 / 3.0)});
  recording.gear_ratio = 349.0;
  recording.lever_arm_m = 0.1;
  recording.loadcell.host_latency = HostLatency{0.002, 0.0};
  return recording;
}

TEST(WriteRecording, ReadsBackExactly) {
  const TemporaryFolder folder;
  const Recording written = small_recording();
  write_recording(written, folder.path() / "made" / "anew");
  const Recording read = read_recording(folder.path() / "made" / "anew");
  EXPECT_EQ(read.module.t_s, written.module.t_s);
  EXPECT_EQ(read.module.host_s, written.module.host_s);
  EXPECT_EQ(read.module.channel("deflection_rad"), written.module.channel("deflection_rad"));
  EXPECT_EQ(read.loadcell.channel("force_n"), written.loadcell.channel("force_n"));
  EXPECT_EQ(read.loadcell.channel("seq"), written.loadcell.channel("seq"));
  EXPECT_EQ(read.gear_ratio, 349.0);
  EXPECT_EQ(read.lever_arm_m, 0.1);
  EXPECT_EQ(read.loadcell.host_latency->latency_s, 0.002);
  EXPECT_FALSE(read.one_clock);
}

TEST(WriteRecording, KeepsOneClockOne) {
  const TemporaryFolder folder;
  Recording written = small_recording();
  written.one_clock = true;
  write_recording(written, folder.path());
  EXPECT_TRUE(read_recording(folder.path()).one_clock);
}

TEST(WriteRecording, RefusesWhatCouldNotBeRead) {
  const TemporaryFolder folder;
  Recording not_finite = small_recording();
  not_finite.module.channels[0].values[5] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(write_recording(not_finite, folder.path()), std::invalid_argument);
  Recording uneven = small_recording();
  uneven.module.channels[0].values.pop_back();
  EXPECT_THROW(write_recording(uneven, folder.path()), std::invalid_argument);
  EXPECT_THROW(write_recording(small_recording(), "/proc/none"), std::runtime_error);
}

}  // namespace
}  // namespace searig::acquisition
