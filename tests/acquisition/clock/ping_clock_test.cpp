#include "acquisition/clock/ping_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace searig::acquisition {
namespace {

constexpr double kPeriod = 600.0;  // s, of the wave of a warming room

/// A device on a line with a fixed part of each way that nobody knows, jitter, and stalls.
struct Device {
  double skew = 0.0, offset_s = 0.0, thermal = 0.0;
  double wire_s = 0.0;                 ///< known: the frame's time on the wire, each way
  double there_s = 0.0, back_s = 0.0;  ///< unknown
  double jitter_s = 0.0, stall_share = 0.01;

  double clock(double host_s) const {
    const double w = 2.0 * std::numbers::pi / kPeriod;
    return offset_s + host_s * (1.0 + skew) + thermal * std::sin(w * host_s) / w;
  }

  Exchange ping(double host_s, std::mt19937_64& random) const {
    const double received = host_s + wire_s + there_s + late(random);
    const double sent = received + 2e-4;
    return {host_s, clock(received), clock(sent), sent + wire_s + back_s + late(random)};
  }

  double late(std::mt19937_64& random) const {
    std::exponential_distribution<double> jitter(1.0 / jitter_s);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    return jitter(random) + (share(random) < stall_share ? 0.06 * share(random) : 0.0);
  }
};

/// An Uno on a USB serial line.
Device loadcell(std::mt19937_64& random) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  return {.skew = 5000e-6 * (2.0 * share(random) - 1.0),
          .offset_s = 4000.0 * share(random),
          .thermal = 20e-6,
          .wire_s = 0.0027,
          .there_s = 0.0008 * share(random),
          .back_s = 0.0008 * share(random),
          .jitter_s = 0.001};
}

TEST(PingClock, LearnsTheRateFromArrivalsThatNobodyAskedFor) {
  std::mt19937_64 random(4);
  const Device device = loadcell(random);
  PingClock few, many;
  for (int i = 0; i < 3000; ++i) {
    const double host_s = 0.02 * i;
    if (i % 500 == 0) {
      const Exchange exchange = device.ping(host_s, random);
      few.take(exchange);
      many.take(exchange);
    }
    const double sent = host_s + 0.005;
    many.take_arrival(device.clock(sent), sent + 0.0027 + device.late(random), 0.0026);
  }
  const auto without = few.at(device.clock(60.0)), with = many.at(device.clock(60.0));
  ASSERT_TRUE(without && with);
  EXPECT_LT(with->rate_ci95, without->rate_ci95);
  EXPECT_LT(with->ci95_s, without->ci95_s);
}

TEST(PingClock, FollowsAClockThatWarms) {
  // So quick a line that a straight line of a minute no longer keeps between the bounds.
  std::mt19937_64 random(6);
  const Device device{.skew = 1e-4,
                      .thermal = 20e-6,
                      .there_s = 2e-5,
                      .back_s = 1e-5,
                      .jitter_s = 5e-6,
                      .stall_share = 0.0};
  PingClock clock;
  for (int second = 0; second < 300; ++second) {
    clock.take(device.ping(second, random));
    if (second < 3) continue;
    const auto estimate = clock.at(device.clock(second));
    ASSERT_TRUE(estimate) << second;
    EXPECT_LE(std::abs(estimate->theta_s - (second - device.clock(second))), estimate->ci95_s);
    EXPECT_LT(estimate->ci95_s, 50e-6);
  }
}

TEST(PingClock, SaysNothingWithoutExchangesAndAfterARestart) {
  PingClock clock;
  EXPECT_FALSE(clock.at(1.0));
  clock.take_arrival(1.0, 5.0, 0.0);
  EXPECT_FALSE(clock.at(1.0));
  clock.take({5.0, 1.001, 1.002, 5.004});
  ASSERT_TRUE(clock.at(1.002));
  EXPECT_NEAR(clock.at(1.002)->theta_s, 4.0, 2e-3);
  clock.restart();
  EXPECT_FALSE(clock.at(1.0));
}

TEST(PingClock, RefusesBoundsThatContradictEachOther) {
  PingClock clock;
  clock.take({5.0, 1.0, 1.001, 5.002});
  clock.take({6.0, 2.5, 2.501, 6.002});  // half a second's step of one clock
  EXPECT_FALSE(clock.at(2.5));
}

}  // namespace
}  // namespace searig::acquisition
