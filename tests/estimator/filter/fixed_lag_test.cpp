#include "estimator/filter/fixed_lag.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "estimator/kinematics.h"

namespace searig::estimator {
namespace {

struct Channel {
  std::vector<double> t, x;
};

// Uneven telemetry with lost frames and one gap.
Channel uneven(double rate_hz) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3), lost(0, 1);
  Channel out;
  for (int i = 0; i < 3000; ++i) {
    if (lost(random) < 0.02 || (i > 1000 && i < 1100)) continue;
    const double t = (i + jitter(random)) / rate_hz;
    out.t.push_back(t);
    out.x.push_back(std::sin(7 * t) + 0.01 * jitter(random));
  }
  return out;
}

std::vector<FixedLag::Rated> stream(const Channel& channel, double half_width_s) {
  FixedLag lag(half_width_s, 256);
  std::vector<FixedLag::Rated> out;
  for (std::size_t i = 0; i < channel.t.size(); ++i) {
    EXPECT_TRUE(lag.push({channel.t[i], channel.x[i], double(i)}));
    while (const auto rated = lag.next()) out.push_back(*rated);
  }
  return out;
}

TEST(FixedLag, LiveIsBatchToTheBit) {
  for (const double rate_hz : {100.0, 250.0, 1000.0}) {
    const Channel channel = uneven(rate_hz);
    const Kinematics batch = differentiate(channel.t, channel.x, 0.02);
    const auto live = stream(channel, 0.02);
    ASSERT_GT(live.size(), channel.t.size() - 30);
    for (std::size_t i = 0; i < live.size(); ++i) {
      ASSERT_EQ(live[i].sample.t, channel.t[i]);
      ASSERT_EQ(live[i].sample.deflection, channel.x[i]);
      ASSERT_EQ(live[i].sample.drive, double(i));
      ASSERT_EQ(live[i].smooth, batch.value[i]) << "sample " << i << " at " << rate_hz;
      ASSERT_EQ(live[i].rate, batch.first[i]) << "sample " << i << " at " << rate_hz;
    }
  }
}

TEST(FixedLag, LagsByTheHalfWidthAndOneSample) {
  FixedLag lag(0.02);
  for (int i = 0; i < 100; ++i) {
    ASSERT_TRUE(lag.push({i * 0.004 + 1e-9 * i, 1, 0}));
    while (const auto rated = lag.next()) {
      EXPECT_LE(i * 0.004 - rated->sample.t, 0.0241);
    }
  }
}

TEST(FixedLag, LeavesOutWhatIsNoNumberOrNotLater) {
  FixedLag lag(0.02);
  EXPECT_TRUE(lag.push({1, 0, 0}));
  EXPECT_FALSE(lag.push({1, 0, 0}));
  EXPECT_FALSE(lag.push({0.9, 0, 0}));
  EXPECT_FALSE(lag.push({std::nan(""), 0, 0}));
  EXPECT_FALSE(lag.push({1.1, std::nan(""), 0}));
  EXPECT_FALSE(lag.push({1.1, 0, std::numeric_limits<double>::infinity()}));
  EXPECT_TRUE(lag.push({1.1, 0, 0}));
}

// 100,000 samples a second do not fit into 256 places for 20 ms either side; they still come back.
TEST(FixedLag, GivesBackEverySampleOfAStreamThatIsTooFast) {
  FixedLag lag(0.02, 256);
  int back = 0;
  for (int i = 0; i < 5000; ++i) {
    ASSERT_TRUE(lag.push({i * 1e-5, i * 1e-5, 0}));
    while (const auto rated = lag.next()) {
      ASSERT_NEAR(rated->rate, 1, 1e-6);
      ++back;
    }
  }
  EXPECT_GT(back, 4500);
}

}  // namespace
}  // namespace searig::estimator
