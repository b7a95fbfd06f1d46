#include "acquisition/recorder/rolling_clock.h"

#include <gtest/gtest.h>

#include "acquisition/clock/ping_clock.h"

namespace searig::acquisition {
namespace {

/// Half a minute of a device whose clock is `ahead_s` before the host's, pinged twice a second.
void run(RollingClock& clock, Stream& stream, StreamId device, double ahead_s, double hz,
         double run_number = 0.0) {
  for (int i = 0; i < 30 * hz; ++i) {
    const double true_s = 100.0 + i / hz, host_s = true_s + 0.003 + 1e-4 * (i % 7);
    clock.take(SampleRow{device, {true_s + ahead_s, host_s, double(i), run_number, 0.0}});
    stream.t_s.push_back(true_s + ahead_s);
    stream.host_s.push_back(host_s);
    if (i % int(hz / 2) != 0) continue;
    clock.take(PingRow{
        device, {host_s, true_s - 0.003, true_s - 0.0001 + ahead_s, true_s + ahead_s, run_number}});
    stream.pings.push_back(
        {true_s - 0.003, true_s - 0.0001 + ahead_s, true_s + ahead_s, host_s, 0});
  }
}

TEST(RollingClock, SaysLiveWhatABatchSaysOfTheSameMinute) {
  RollingClock clock;
  mcap::Settings settings;
  settings.loadcell.baud = 115200;
  clock.take(NewSettings{0.0, settings});
  EXPECT_FALSE(clock.estimate());
  Recording batch;
  batch.module.name = "module";
  batch.loadcell.name = "loadcell";
  batch.loadcell.least_wire_s = least_ping_wire_s(115200);
  run(clock, batch.module, StreamId::module, 437.5, 200.0);
  run(clock, batch.loadcell, StreamId::loadcell, -20.0, 50.0);
  const auto live = clock.estimate();
  const ClockMap map = synchronise(batch);
  ASSERT_TRUE(live);
  EXPECT_EQ(live->rate, map.rate);
  EXPECT_EQ(live->offset_s, map.offset_s);
  EXPECT_EQ(live->ci95_s, map.ci95_s);
  EXPECT_EQ(live->why, map.why);
  EXPECT_NE(live->why.find("two-way pings"), std::string::npos) << live->why;
  EXPECT_NEAR(live->to_module(80.0), 537.5, live->ci95_s);
}

TEST(RollingClock, BeginsAnewWithTheDevice) {
  RollingClock clock;
  Stream ignored;
  run(clock, ignored, StreamId::module, 437.5, 200.0);
  run(clock, ignored, StreamId::loadcell, -20.0, 50.0);
  ASSERT_TRUE(clock.estimate());
  clock.take(SampleRow{StreamId::loadcell, {0.0, 131.0, 0.0, 1.0, 0.0}});
  EXPECT_FALSE(clock.estimate());
  run(clock, ignored, StreamId::loadcell, -100.0, 50.0, 2.0);
  ASSERT_TRUE(clock.estimate());
  EXPECT_NEAR(clock.estimate()->to_module(10.0), 547.5, 0.004);
}

}  // namespace
}  // namespace searig::acquisition
