#include "app/session/device_channels.h"

#include <gtest/gtest.h>

#include "app/session/session.h"

namespace searig::app {
namespace {

using namespace acquisition;

/// The module samples 0..9 s; the device, 100 s ahead, samples its angle of 3 rad/s from 102 to 107
/// s, with a pause from `pause_from` rows on.
Recording with_device(double pause_s) {
  Recording recording;
  recording.one_clock = true;
  recording.module.name = "module";
  recording.loadcell.name = "loadcell";
  Device device{{}, AlignedBy::host};
  device.stream.name = "device.encoder";
  std::vector<double> angle, current, torque;
  for (int i = 0; i < 1000; ++i) {
    const double t = 0.01 * i;
    recording.module.t_s.push_back(t);
    current.push_back(1.0);
    recording.loadcell.t_s.push_back(t);
    torque.push_back(2.0);
    if (t < 2.0 || t > 7.0 || (t > 4.0 && t < 4.0 + pause_s)) continue;
    device.stream.t_s.push_back(t + 100.0);
    angle.push_back(3.0 * t);
  }
  recording.module.channels = {{"current_a", current}};
  recording.loadcell.channels = {{"torque_nm", torque}};
  device.stream.channels = {{"input_angle_rad", angle}};
  recording.devices = {device};
  return recording;
}

/// What synchronise() would find.
ClockMap known_map(const Recording& recording) {
  ClockMap map;
  map.offset_s = -100.0;
  map.loadcell_runs = {{0, recording.devices[0].stream.t_s.size(), 1.0, -100.0}};
  return map;
}

PlacedRows all_rows(const Recording& recording) {
  return place_rows(recording.module, {{0, recording.module.t_s.size(), 1.0, 0.0}});
}

TEST(DeviceChannels, StandAtTheModulesRowsThatTheDeviceCovers) {
  const Recording recording = with_device(0.05);
  const std::vector<ClockMap> maps{known_map(recording)};
  const PlacedRows rows = covered_rows(recording, maps, all_rows(recording));
  EXPECT_NEAR(rows.t_s.front(), 2.0, 0.011);
  EXPECT_NEAR(rows.t_s.back(), 7.0, 0.011);
  const auto channels = device_channels(recording, maps, rows);
  ASSERT_EQ(channels.size(), 1u);
  EXPECT_EQ(channels[0].name, "input_angle_rad");
  for (std::size_t i = 0; i < rows.t_s.size(); ++i)  // straight through the short pause
    ASSERT_NEAR(channels[0].values[i], 3.0 * rows.t_s[i], 1e-9);
}

TEST(DeviceChannels, NothingIsInventedInALongPause) {
  const Recording recording = with_device(0.5);
  const PlacedRows rows = covered_rows(recording, {known_map(recording)}, all_rows(recording));
  for (const double t : rows.t_s) EXPECT_FALSE(t > 4.005 && t < 4.495) << t;
  EXPECT_NEAR(double(rows.rows.size()), 450, 4);
}

TEST(DeviceChannels, ASessionHasThemInItsSignals) {
  Recording recording = with_device(0.0);
  recording.devices[0].aligned_by = AlignedBy::clock;
  for (double& t : recording.devices[0].stream.t_s) t -= 100.0;
  const Session session = session_of(recording);
  const auto& module = session.signals.module;
  ASSERT_EQ(module.input_angle_rad.size(), module.t_s.size());
  ASSERT_EQ(module.current_a.size(), module.t_s.size());
  EXPECT_NEAR(module.input_angle_rad.front(), 3.0 * module.t_s.front(), 1e-9);
  EXPECT_LT(module.t_s.size(), recording.module.t_s.size());
}

}  // namespace
}  // namespace searig::app
