#include "acquisition/clock/host_clock.h"

#include <gtest/gtest.h>

#include "acquisition/clock/doubt.h"
#include "acquisition/clock/host_timer.h"
#include "tests/acquisition/clock/simulated_device.h"

namespace searig::acquisition {
namespace {

TEST(HostLine, FindsRateErrorsOfFiveThousandPpmEitherWay) {
  for (const double ppm : {-5000.0, -2021.0, 0.0, 5000.0}) {
    std::mt19937_64 random(3);
    const Stream stream = SimulatedDevice{.ppm = ppm, .offset_s = 504.0}.run(random, "loadcell");
    const HostLine line = fit_host_line(stream.t_s, stream.host_s);
    EXPECT_NEAR(1.0 / line.rate(), 1.0 + ppm * 1e-6, 0.5e-6) << ppm;
  }
}

TEST(HostLine, IsNotMovedByLostRowsNorByStalls) {
  std::mt19937_64 random(4);
  const SimulatedDevice device{.ppm = 2000.0, .lost_share = 0.01, .stall_share = 0.005};
  const Stream stream = device.run(random, "loadcell");
  const HostLine line = fit_host_line(stream.t_s, stream.host_s);
  for (const double true_s : {0.0, 37.0, 75.0})
    EXPECT_NEAR(line.host(device.device_time(true_s)), true_s, 1e-4);
}

TEST(HostLine, OfAShortRunBorrowsItsRate) {
  std::mt19937_64 random(5);
  const SimulatedDevice device{.seconds = 2.0, .ppm = -1500.0};
  const Stream stream = device.run(random, "loadcell");
  const HostLine line = fit_host_line(stream.t_s, stream.host_s, 1500e-6);
  EXPECT_NEAR(line.host(device.device_time(60.0)), 60.0, 1e-3);
}

TEST(HostTimer, IsHeardInArrivalsOnlyAtItsTicks) {
  std::mt19937_64 random(6);
  const Stream quiet = SimulatedDevice{}.run(random, "loadcell");
  const Stream ticks = SimulatedDevice{.ppm = 800.0, .timer_s = kUsbTimer}.run(random, "loadcell");
  const Stream fast = SimulatedDevice{.hz = 250.0}.run(random, "module");
  EXPECT_EQ(timer_in(quiet.t_s, quiet.host_s), Timer::absent);
  EXPECT_EQ(timer_in(ticks.t_s, ticks.host_s), Timer::heard);
  EXPECT_EQ(timer_in(fast.t_s, fast.host_s), Timer::absent);
}

TEST(HostTimer, CannotBeToldFromADeviceThatKeepsItsBeat) {
  std::mt19937_64 random(6);
  const SimulatedDevice beat{.hz = 62.5, .ppm = 3.0, .mean_latency_s = 1e-4, .timer_s = kUsbTimer};
  const Stream locked = beat.run(random, "loadcell");
  const HostLine line = fit_host_line(locked.t_s, locked.host_s);
  EXPECT_EQ(line.timer, Timer::locked);
  EXPECT_GT(line.ci95_s(), 0.010);
  const std::string why = doubt(locked, {runs_of(locked).front(), line, std::nullopt, 0.0});
  EXPECT_NE(why.find("whole multiple of the 16 ms"), std::string::npos) << why;
}

TEST(HostTimer, LeavesAsMuchUnseenAsTheWidestGapBetweenWaits) {
  EXPECT_NEAR(unseen_wait(std::vector<double>{0.0, 0.004, 0.008, 0.012, 0.030}, 0.016), 0.004,
              1e-12);
  EXPECT_NEAR(unseen_wait(std::vector<double>{0.0, 0.0001}, 0.016), 0.0159, 1e-12);
}

TEST(Runs, AreCutAtRestarts) {
  Stream stream;
  stream.t_s = {0.0, 1.0, 2.0, 0.1, 9.0, 0.2};
  stream.restarts = {3, 5};
  const auto runs = runs_of(stream);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_EQ(runs[1].first, 3u);
  EXPECT_EQ(runs[1].last, 5u);
  EXPECT_EQ(longest_run(stream), 1u);
}

}  // namespace
}  // namespace searig::acquisition
