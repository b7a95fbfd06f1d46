// Recordings with two-way pings through synchronise(), as `searig sync` has them: how near the
// truth, and whether the stated interval holds it. Simulated time, seeded.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "acquisition/clock/ping_clock.h"
#include "acquisition/clock/synchronise.h"

namespace searig::acquisition {
namespace {

/// A device on a line with a fixed part of each way that nobody knows, jitter, and stalls.
struct Device {
  double hz = 50.0, skew = 0.0, offset_s = 0.0;
  double thermal = 0.0;  ///< a wave of the rate, as long as thermal_period_s
  double thermal_period_s = 600.0;
  double wire_s = 0.0;                 ///< known: a ping's time on the wire, each way
  double there_s = 0.0, back_s = 0.0;  ///< unknown
  double jitter_s = 0.001;
  double age_s = 0.0;  ///< of a reading when it is sent, at the most

  double clock(double true_s) const {
    const double w = 2.0 * std::numbers::pi / thermal_period_s;
    return offset_s + true_s * (1.0 + skew) + thermal * std::sin(w * true_s) / w;
  }

  /// 60 ms stalls befall one in two hundred.
  double late(std::mt19937_64& random) const {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    return std::exponential_distribution<double>(1.0 / jitter_s)(random) +
           (share(random) < 0.005 ? 0.06 * share(random) : 0.0);
  }

  void ping(Stream& stream, double host_s, std::mt19937_64& random) const {
    const double received = host_s + wire_s + there_s + late(random), sent = received + 3e-4;
    stream.pings.push_back({host_s, clock(received), clock(sent),
                            sent + wire_s + back_s + late(random), stream.restarts.size()});
  }

  /// Samples and two pings a second from one true time to another, behind what is there.
  void run(Stream& stream, double from_s, double to_s, std::mt19937_64& random) const {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    if (!stream.t_s.empty()) stream.restarts.push_back(stream.t_s.size());
    double heard_s = 0.0;
    for (double at_s = from_s + 0.02 * share(random); at_s < to_s; at_s += 1.0 / hz) {
      if (share(random) < 0.01) continue;  // lost
      heard_s = std::max(heard_s, at_s + age_s * share(random) + wire_s + back_s + late(random));
      stream.t_s.push_back(clock(at_s));
      stream.host_s.push_back(heard_s);
    }
    for (double at_s = from_s + 0.1; at_s < to_s - 0.5; at_s += 0.5) ping(stream, at_s, random);
    stream.least_wire_s = wire_s > 0.0 ? least_ping_wire_s(115200) : 0.0;
    stream.counts.received = stream.t_s.size();
  }
};

/// An Uno on a USB serial line and a module on a network, with clocks and ways of their own.
struct Rig {
  Device loadcell, module;

  explicit Rig(std::mt19937_64& random) {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    loadcell = {.skew = 5000e-6 * (2.0 * share(random) - 1.0),
                .offset_s = 4000.0 * share(random),
                .wire_s = 0.00272,
                .there_s = 0.0004 * share(random),
                .back_s = 0.0004 * share(random),
                .jitter_s = 0.0008,
                .age_s = 0.011};
    module = {.hz = 200.0,
              .skew = 50e-6 * (2.0 * share(random) - 1.0),
              .offset_s = 1000.0 * share(random),
              .there_s = 0.0001 + 0.0002 * share(random),
              .back_s = 0.0001 + 0.0002 * share(random),
              .jitter_s = 0.0002};
  }

  Recording record(double seconds, std::mt19937_64& random) const {
    Recording recording;
    recording.module.name = "module";
    recording.loadcell.name = "loadcell";
    module.run(recording.module, 0.0, seconds, random);
    loadcell.run(recording.loadcell, 0.0, seconds, random);
    return recording;
  }

  /// By the map of the load cell's run that a true time lies in.
  double error_at(const Recording& recording, const ClockMap& map, double true_s) const {
    const double loadcell_s = loadcell.clock(true_s);
    for (const RunMap& run : map.loadcell_runs)
      if (recording.loadcell.t_s[run.last - 1] >= loadcell_s)
        return run.rate * loadcell_s + run.offset_s - module.clock(true_s);
    const RunMap& last = map.loadcell_runs.back();
    return last.rate * loadcell_s + last.offset_s - module.clock(true_s);
  }
};

TEST(Pinged, AHundredRunsAreWithinAMillisecondAndTheIntervalHoldsTheTruth) {
  int covered = 0;
  double worst = 0.0, widest = 0.0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    std::mt19937_64 random(seed);
    const Rig rig(random);
    const Recording recording = rig.record(75.0, random);
    const ClockMap map = synchronise(recording);
    EXPECT_TRUE(map.trusted) << map.why;
    const double error = std::abs(rig.error_at(recording, map, 37.5));
    covered += error <= map.ci95_s;
    widest = std::max(widest, map.ci95_s);
    for (const double at_s : {1.0, 20.0, 37.5, 55.0, 74.0})
      worst = std::max(worst, std::abs(rig.error_at(recording, map, at_s)));
  }
  std::printf("100 runs: worst error %.3f ms, widest interval +-%.3f ms, covered %d\n", 1e3 * worst,
              1e3 * widest, covered);
  EXPECT_LT(worst, 1e-3);
  EXPECT_GE(covered, 95);
  EXPECT_LT(widest, 1e-3);  // and not by saying nothing
}

TEST(Pinged, FollowsAResonatorThatWarmsForTwentyMinutes) {
  double worst = 0.0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    std::mt19937_64 random(seed);
    Rig rig(random);
    rig.loadcell.thermal = 20e-6;
    rig.module.hz = 100.0;
    const Recording recording = rig.record(1200.0, random);
    const ClockMap map = synchronise(recording);
    EXPECT_TRUE(map.trusted) << map.why;
    EXPECT_NE(map.why.find("unevenly"), std::string::npos) << map.why;
    EXPECT_LE(std::abs(rig.error_at(recording, map, 600.0)), map.ci95_s);
    for (double at_s = 1.0; at_s < 1199.0; at_s += 3.0)
      worst = std::max(worst, std::abs(rig.error_at(recording, map, at_s)));
  }
  std::printf("20 min of +-20 ppm: worst error anywhere %.3f ms\n", 1e3 * worst);
  EXPECT_LT(worst, 1e-3);
}

TEST(Pinged, PlacesEveryRunOfADeviceThatRestarted) {
  std::mt19937_64 random(3);
  const Rig rig(random);
  Recording recording = rig.record(60.0, random);
  Device again = rig.loadcell;
  again.offset_s = 0.0;
  again.offset_s = -again.clock(70.0);  // its clock begins at 0
  again.run(recording.loadcell, 70.0, 78.0, random);
  const ClockMap map = synchronise(recording);
  ASSERT_EQ(map.loadcell_runs.size(), 2u);
  const RunMap& second = map.loadcell_runs[1];
  const double module_s = second.rate * again.clock(74.0) + second.offset_s;
  EXPECT_NEAR(module_s, rig.module.clock(74.0), 1e-3);
}

TEST(Pinged, ByOnePingedStreamTheOtherIsNotKnownBetter) {
  std::mt19937_64 random(4);
  const Rig rig(random);
  Recording recording = rig.record(60.0, random);
  recording.module.pings.clear();
  const ClockMap map = synchronise(recording);
  EXPECT_GT(map.ci95_s, 0.002);
  EXPECT_LE(std::abs(rig.error_at(recording, map, 30.0)), map.ci95_s);
}

/// Behind native USB no byte takes its time on a wire, whatever baud the port was given.
TEST(Pinged, DoesNotBelieveInAWireThatIsNotThere) {
  std::mt19937_64 random(5);
  Rig rig(random);
  rig.loadcell.wire_s = 0.0;
  rig.loadcell.age_s = 0.0;
  rig.loadcell.jitter_s = 1e-4;
  Recording recording = rig.record(60.0, random);
  recording.loadcell.least_wire_s = least_ping_wire_s(115200);
  const ClockMap map = synchronise(recording);
  EXPECT_LE(std::abs(rig.error_at(recording, map, 30.0)), map.ci95_s);
  EXPECT_LT(std::abs(rig.error_at(recording, map, 30.0)), 1e-3);
}

/// Four samples in 64 ms: waiting for a USB timer would not show in the arrivals. Pings tell.
TEST(Pinged, TrustsABeatThatHidesTheHostsTimer) {
  std::mt19937_64 random(6);
  Rig rig(random);
  Recording recording = rig.record(60.0, random);
  Stream& loadcell = recording.loadcell;
  for (double& host_s : loadcell.host_s) host_s = std::ceil(host_s / 0.016) * 0.016;
  for (Exchange& ping : loadcell.pings)
    ping.host_received_s = std::ceil(ping.host_received_s / 0.016) * 0.016;
  const ClockMap map = synchronise(recording);
  EXPECT_TRUE(map.trusted) << map.why;
  EXPECT_LE(std::abs(rig.error_at(recording, map, 30.0)), map.ci95_s);
  EXPECT_LT(map.ci95_s, 0.002);
}

}  // namespace
}  // namespace searig::acquisition
