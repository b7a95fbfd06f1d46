#include "acquisition/clock/synchronise.h"

#include <gtest/gtest.h>

#include "acquisition/clock/host_timer.h"
#include "tests/acquisition/clock/simulated_device.h"

namespace searig::acquisition {
namespace {

/// What a wire may do to a load cell, all at once.
SimulatedPair rough_pair() {
  SimulatedPair pair;
  pair.module.ppm = 50.0;
  pair.module.lost_share = 0.01;
  pair.module.stall_share = 0.0005;
  pair.loadcell.ppm = -5000.0;
  pair.loadcell.lost_share = 0.01;
  pair.loadcell.stall_share = 0.002;
  pair.loadcell.timer_s = 0.016;
  return pair;
}

double error_at(const SimulatedPair& pair, const ClockMap& map, double true_s) {
  return map.to_module(pair.loadcell.device_time(true_s)) - pair.module.device_time(true_s);
}

/// How often the interval holds the truth at the middle, over 200 seeds; with latencies declared
/// as they are (fixed = 0), or unknown and anywhere up to `fixed`.
double coverage(SimulatedPair pair, double fixed, double* worst_s = nullptr) {
  constexpr int kSeeds = 200;
  int covered = 0;
  for (int seed = 0; seed < kSeeds; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    pair.module.offset_s = 1000.0 * share(random);
    pair.loadcell.offset_s = 1000.0 * share(random);
    pair.module.fixed_latency_s = fixed * share(random);
    pair.loadcell.fixed_latency_s = fixed * share(random);
    Recording recording = pair.record(random);
    if (fixed == 0.0)
      recording.module.host_latency = recording.loadcell.host_latency = HostLatency{};
    const ClockMap map = synchronise(recording);
    EXPECT_TRUE(map.trusted) << map.why;
    covered += std::abs(error_at(pair, map, 0.5 * pair.loadcell.seconds)) <= map.ci95_s;
    if (worst_s)
      for (const double at : {0.0, 0.25, 0.5, 0.75, 1.0})
        *worst_s = std::max(*worst_s, std::abs(error_at(pair, map, at * pair.loadcell.seconds)));
  }
  return covered / double(kSeeds);
}

TEST(Synchronise, IntervalCoversTheTruthOnAQuietWire) {
  EXPECT_GE(coverage({}, 0.0), 0.95);
}

TEST(Synchronise, IntervalCoversTheTruthOnARoughWire) {
  double worst_s = 0.0;
  EXPECT_GE(coverage(rough_pair(), 0.0, &worst_s), 0.95);
  EXPECT_LT(worst_s, 0.001);
}

TEST(Synchronise, IntervalCoversWhatFixedLatenciesHide) {
  double worst_s = 0.0;
  EXPECT_GE(coverage(rough_pair(), 0.004, &worst_s), 0.95);
  EXPECT_LT(worst_s, 0.005);
}

TEST(Synchronise, IntervalCoversTheTruthWhenTheTimerLocksToTheBeat) {
  SimulatedPair pair = rough_pair();
  pair.loadcell.ppm = 0.0;  // 20 ms and 16 ms share 4 ms: waits come in four sizes only
  EXPECT_GE(coverage(pair, 0.0), 0.90);
}

TEST(Synchronise, IntervalCoversTenMinutesOfThermalDrift) {
  SimulatedPair pair = rough_pair();
  pair.loadcell.ppm = 5000.0;
  pair.loadcell.thermal_ppm = 20.0;
  pair.loadcell.seconds = 600.0;
  pair.module.seconds = 600.0;
  pair.module.hz = 100.0;
  double worst_s = 0.0;
  EXPECT_GE(coverage(pair, 0.0, &worst_s), 0.90);
  EXPECT_LT(worst_s, 0.005);
}

TEST(Synchronise, MapsEveryRunOfADeviceThatRestarted) {
  std::mt19937_64 random(7);
  SimulatedPair pair;
  pair.loadcell.ppm = 1200.0;
  Recording recording = pair.record(random);
  SimulatedDevice again = pair.loadcell;  // its clock begins anew when it is switched on again
  again.seconds = 20.0;
  again.offset_s = -again.device_time(80.0);
  const Stream second = again.run(random, "loadcell", 80.0 * (1.0 + again.ppm * 1e-6));
  Stream& loadcell = recording.loadcell;
  loadcell.restarts.push_back(loadcell.t_s.size());
  loadcell.t_s.insert(loadcell.t_s.end(), second.t_s.begin(), second.t_s.end());
  loadcell.host_s.insert(loadcell.host_s.end(), second.host_s.begin(), second.host_s.end());

  const ClockMap map = synchronise(recording);
  ASSERT_EQ(map.loadcell_runs.size(), 2u);
  const std::vector<double> module_s = on_module_clock(loadcell, map.loadcell_runs);
  for (std::size_t row = 0; row < module_s.size(); ++row) {
    const double latency = loadcell.host_s[row] - module_s[row];  // the module's clock is true
    ASSERT_GT(latency, -1e-3) << row;
    ASSERT_LT(latency, 0.06) << row;
  }
}

TEST(Synchronise, DeclaredLatenciesMoveTheMapAndNarrowTheInterval) {
  std::mt19937_64 random(8);
  SimulatedPair pair;
  pair.module.fixed_latency_s = 0.0003;
  pair.loadcell.fixed_latency_s = 0.0030;
  Recording recording = pair.record(random);
  const double blind = error_at(pair, synchronise(recording), 37.0);
  recording.module.host_latency = HostLatency{0.0003, 0.0001};
  recording.loadcell.host_latency = HostLatency{0.0030, 0.0002};
  const ClockMap told = synchronise(recording);
  EXPECT_NEAR(blind, 0.0027, 1e-4);
  EXPECT_NEAR(error_at(pair, told, 37.0), 0.0, 1e-4);
  EXPECT_LT(told.ci95_s, 0.0004);
}

TEST(Synchronise, StreamsWithoutHostStampsInBothAreOneClock) {
  std::mt19937_64 random(9);
  Recording recording = SimulatedPair{}.record(random);
  recording.module.host_s.clear();
  const ClockMap map = synchronise(recording);
  EXPECT_EQ(map.rate, 1.0);
  EXPECT_EQ(map.offset_s, 0.0);
  EXPECT_EQ(map.ci95_s, 0.0);
  EXPECT_TRUE(map.trusted);
}

TEST(Synchronise, DoesNotTrustADeviceWhoseBeatHidesTheHostsTimer) {
  for (const double hz : {62.5, 31.25}) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      std::mt19937_64 random(seed);
      SimulatedPair pair;
      pair.loadcell = {.hz = hz, .ppm = 2.0, .mean_latency_s = 2e-4, .timer_s = kUsbTimer};
      const ClockMap map = synchronise(pair.record(random));
      EXPECT_FALSE(map.trusted) << hz << " Hz, seed " << seed;
      EXPECT_LE(std::abs(error_at(pair, map, 37.0)), map.ci95_s) << hz << " Hz, seed " << seed;
    }
  }
}

TEST(Synchronise, TrustsADeviceOfThatBeatWhoseWireShowsThatNoTimerIsThere) {
  std::mt19937_64 random(14);
  SimulatedPair pair;
  pair.loadcell.hz = 62.5;
  const ClockMap map = synchronise(pair.record(random));
  EXPECT_TRUE(map.trusted) << map.why;
  EXPECT_LT(map.ci95_s, 0.005);
}

TEST(Synchronise, DoesNotTrustOneClockOnWhichTheStreamsNeverMeet) {
  std::mt19937_64 random(15);
  Recording recording = SimulatedPair{}.record(random);
  recording.module.host_s.clear();
  for (double& t : recording.loadcell.t_s) t += 500.0;
  const ClockMap map = synchronise(recording);
  EXPECT_FALSE(map.trusted);
  EXPECT_NE(map.why.find("never ran at the same time"), std::string::npos) << map.why;
}

TEST(Synchronise, DoesNotTrustWhatIsTooShortOrToldByTooFew) {
  std::mt19937_64 random(10);
  SimulatedPair brief;
  brief.module.seconds = brief.loadcell.seconds = 3.0;
  const ClockMap map = synchronise(brief.record(random));
  EXPECT_FALSE(map.trusted);
  EXPECT_NE(map.why.find("3.0 s"), std::string::npos) << map.why;
  SimulatedPair sparse;
  sparse.loadcell.hz = 0.5;
  EXPECT_FALSE(synchronise(sparse.record(random)).trusted);
}

TEST(Synchronise, DoesNotTrustAHostClockThatWasSet) {
  std::mt19937_64 random(11);
  Recording recording = SimulatedPair{}.record(random);
  std::vector<double>& host = recording.loadcell.host_s;
  for (std::size_t row = host.size() / 3; row < host.size(); ++row) host[row] += 0.2;
  EXPECT_FALSE(synchronise(recording).trusted);
}

TEST(Synchronise, DoesNotTrustStreamsOfDifferentTimes) {
  std::mt19937_64 random(12);
  Recording recording = SimulatedPair{}.record(random);
  for (double& host : recording.loadcell.host_s) host += 4000.0;
  const ClockMap map = synchronise(recording);
  EXPECT_FALSE(map.trusted);
  EXPECT_NE(map.why.find("same time"), std::string::npos) << map.why;
}

TEST(Synchronise, DoesNotTrustARateThatNoClockHas) {
  std::mt19937_64 random(13);
  SimulatedPair pair;
  pair.loadcell.ppm = 30000.0;
  EXPECT_FALSE(synchronise(pair.record(random)).trusted);
}

}  // namespace
}  // namespace searig::acquisition
