#include "acquisition/clock/align_velocity.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>
#include <vector>

namespace searig::acquisition {
namespace {

/// A reference that reports a noisy velocity at 50 Hz for 40 s, and a device that logs the angle
/// on a clock of its own: reference time = rate * device time + offset.
struct Pair {
  std::function<double(double)> angle;  ///< rad, over reference time
  double rate = 1.0 + 30e-6, offset_s = -37.4;
  double from_s = 2.0, to_s = 38.0;  ///< the device's log, reference time
  double noise_rad_s = 0.3, bias_rad_s = 0.1, gain = 1.7;

  Alignment aligned(int seed) const {
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    std::normal_distribution<double> normal;
    std::vector<double> t, v, device, q;
    double slow = 0.0;  // half of the noise is correlated over 0.1 s
    for (double at = 0.0; at < 40.0; at += 0.02) {
      slow = 0.8 * slow + 0.6 * normal(random);
      t.push_back(at);
      v.push_back(gain * (angle(at + 0.01) - angle(at - 0.01)) / 0.02 + bias_rad_s +
                  noise_rad_s * 0.7 * (normal(random) + slow));
    }
    for (double at = from_s; at < to_s; at += 0.0083) {
      device.push_back((at - offset_s) / rate);
      q.push_back(angle(at) + 1e-3 * normal(random));
    }
    return align_by_velocity(t, v, device, q);
  }

  /// At the middle of the device's log, reference clock.
  double error(const Alignment& found) const {
    const double middle = 0.5 * (from_s + to_s);
    return found.rate * (middle - offset_s) / rate + found.offset_s - middle;
  }
};

/// Irregular, as a hand moves a lever.
double by_hand(double t) {
  return std::sin(0.9 * t) + 0.6 * std::sin(2.3 * t + std::sin(0.17 * t * t / 10.0)) +
         0.4 * std::sin(0.31 * t);
}

/// Turns at 1 rad/s between 2 and 38 s and stands still otherwise.
double one_way(double t) {
  return std::clamp(t, 2.0, 38.0);
}

void expect_covered(const Pair& pair, double widest_s) {
  int covered = 0;
  constexpr int kSeeds = 20;
  for (int seed = 0; seed < kSeeds; ++seed) {
    const Alignment found = pair.aligned(seed);
    ASSERT_TRUE(found.trusted) << found.why;
    covered += std::abs(pair.error(found)) <= found.ci95_s;
    EXPECT_LT(found.ci95_s, widest_s);
  }
  EXPECT_GE(covered, 18);  // 95 % of 20, less one
}

TEST(AlignByVelocity, IntervalCoversTheTruthWhereAHandMoves) {
  expect_covered({by_hand}, 0.1);
}

TEST(AlignByVelocity, ALogThatBeginsAndEndsWithItsMotionIsPlacedByItsEnds) {
  expect_covered({one_way}, 0.1);
}

TEST(AlignByVelocity, SaysThatAMotionMadeTwiceIsAlikeElsewhere) {
  const auto burst = [](double t) { return 1.0 / (1.0 + std::exp(-4.0 * t)); };
  Pair pair{[=](double t) { return burst(t - 10.0) + burst(t - 30.0); }};
  pair.from_s = 5.0, pair.to_s = 15.0;
  pair.noise_rad_s = 0.1;
  const Alignment found = pair.aligned(1);
  EXPECT_FALSE(found.trusted);
  EXPECT_NE(found.why.find("as much alike"), std::string::npos) << found.why;
}

TEST(AlignByVelocity, SaysThatNothingIsAlike) {
  Pair pair{by_hand};
  pair.gain = 0.0;
  const Alignment found = pair.aligned(1);
  EXPECT_FALSE(found.trusted);
  EXPECT_NE(found.why.find("chance"), std::string::npos) << found.why;
}

TEST(AlignByVelocity, AnAngleOfTheOtherSignIsNotAlike) {
  Pair pair{one_way};
  pair.gain = -1.7;
  pair.noise_rad_s = 0.01;
  EXPECT_FALSE(pair.aligned(1).trusted);
}

}  // namespace
}  // namespace searig::acquisition
