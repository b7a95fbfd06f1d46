// A rig that is known exactly, followed live: entries in, columns out.
#include "app/rig/live_follower.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace searig::app {
namespace {

using acquisition::Columns;
using acquisition::Entry;
using acquisition::SampleRow;
using acquisition::StreamId;

constexpr double stiffness = 40.0, torque_constant = 2.0, offset_s = 100.0;

estimator::Model motor_alone() {
  estimator::Model model;
  model.set("spring.linear", "k_nm_per_rad", 60.0);
  model.set("drive.motor", "torque_constant_nm_per_a", torque_constant);
  model.set("drive.motor", "efficiency", 1.0);
  return model;
}

double deflection(double t) {
  return 0.1 * std::sin(2.0 * t) + 0.03 * std::sin(7.0 * t);
}

/// Both devices from one true time to another: the load cell's clock is 100 s behind the module's.
std::vector<Entry> devices(double from_s, double to_s, double run = 0.0,
                           double module_clock = 0.0) {
  static std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0.0, 0.02);
  std::vector<Entry> entries;
  for (long i = std::lround(500.0 * from_s); i < std::lround(500.0 * to_s); ++i) {
    const double t = double(i) / 500.0, theta = deflection(t);
    entries.push_back(SampleRow{StreamId::module,
                                {t + module_clock, 1000.0 + t, double(i), run, theta, 0.0,
                                 (stiffness * theta + noise(random)) / torque_constant}});
    if (i % 10 == 0)
      entries.push_back(SampleRow{StreamId::loadcell,
                                  {t - offset_s, 1000.0 + t + 5e-4, double(i / 10), 0.0,
                                   stiffness * theta + 0.01 * noise(random)}});
  }
  return entries;
}

class Following {
 public:
  explicit Following(FollowOptions options = {1.0, {}, motor_alone()}) : follower(options) {
    follower.take({Columns{StreamId::module,
                           {"t_s", "host_s", "seq", "run", "input_angle_rad", "output_angle_rad",
                            "current_a"}},
                   Columns{StreamId::loadcell, {"t_s", "host_s", "seq", "run", "force_n"}}});
  }
  void run(double from_s, double to_s, double step_s = 0.05, double module_run = 0.0,
           double module_clock = 0.0) {
    int steps = 0;
    for (double t = from_s; t < to_s - 1e-9; t += step_s) {
      follower.take(devices(t, t + step_s, module_run, module_clock));
      if (++steps % 20 == 0) follower.hold_clocks();
      follower.follow(seen);
    }
  }
  LiveFollower follower;
  LiveColumns seen;
};

TEST(LiveFollower, FindsTheStiffnessWithAnIntervalThatHoldsIt) {
  Following live;
  live.run(0.0, 40.0);
  EXPECT_NEAR(live.seen.k_nm_per_rad.back(), stiffness, 0.02 * stiffness);
  EXPECT_LT(live.seen.k_low_nm_per_rad.back(), stiffness + 0.05);
  EXPECT_GT(live.seen.k_high_nm_per_rad.back(), stiffness - 0.05);
  EXPECT_LT(live.seen.k_high_nm_per_rad.back() - live.seen.k_low_nm_per_rad.back(), 2.0);
  EXPECT_LT(live.seen.error_percent(20.0), 3.0);
}

TEST(LiveFollower, TheClocksWidenTheIntervalWhereTheTorqueChanges) {
  Following live;
  live.run(0.0, 20.0);
  ASSERT_TRUE(live.follower.clock());
  const LiveColumns& c = live.seen;
  for (std::size_t i = 8000; i < c.t_s.size(); i += 50) {
    const double t = c.t_s[i];
    const double rate = stiffness * (0.2 * std::cos(2.0 * t) + 0.21 * std::cos(7.0 * t));
    const double by_clock = c.high_nm[i] - c.clock_high_nm[i];
    EXPECT_NEAR(-by_clock, std::abs(rate) * live.follower.clock()->ci95_s, 0.01) << t;
    EXPECT_NEAR(c.low_nm[i] - c.clock_low_nm[i], -by_clock, 1e-9);
  }
}

TEST(LiveFollower, ShowsTheSameHoweverOftenItIsAsked) {
  Following often, seldom;
  often.run(0.0, 8.0, 0.02);
  seldom.run(0.0, 8.0, 0.4);
  const std::size_t size = std::min(often.seen.t_s.size(), seldom.seen.t_s.size());
  ASSERT_GT(size, 3500u);
  for (std::size_t i = 0; i < size; i += 37) {
    ASSERT_EQ(often.seen.t_s[i], seldom.seen.t_s[i]);
    ASSERT_NEAR(often.seen.torque_nm[i], seldom.seen.torque_nm[i], 0.2);
  }
}

TEST(LiveFollower, TimeGoesOnWhereTheModuleBeganAnew) {
  Following live;
  live.run(0.0, 10.0);
  live.run(10.0, 20.0, 0.05, 1.0, -10.0);  // its clock begins at 0 again
  for (const auto* t : {&live.seen.t_s, &live.seen.loadcell_t_s})
    EXPECT_TRUE(std::is_sorted(t->begin(), t->end()));
  EXPECT_NEAR(live.seen.t_s.back(), 20.0, 0.2);
  EXPECT_NEAR(live.seen.loadcell_t_s.back(), 20.0, 0.1);
  EXPECT_NEAR(live.seen.k_nm_per_rad.back(), stiffness, 0.05 * stiffness);
}

TEST(LiveFollower, TheTailReachesTheNewestSample) {
  Following live;
  live.run(0.0, 5.0);
  std::vector<double> t_s, torque_nm;
  live.follower.tail(t_s, torque_nm);
  ASSERT_FALSE(t_s.empty());
  EXPECT_EQ(t_s.front(), live.seen.t_s.back());
  EXPECT_DOUBLE_EQ(t_s.back(), live.follower.now_s());
  EXPECT_LT(t_s.back() - t_s.front(), 0.15);
}

TEST(LiveFollower, WithoutAModelTheTorqueIsMeasuredAllTheSame) {
  Following live(FollowOptions{1.0, {}, {}});
  live.run(0.0, 3.0);
  EXPECT_TRUE(live.seen.t_s.empty());
  EXPECT_GT(live.seen.loadcell_t_s.size(), 140u);
}

TEST(LiveColumns, LetGoOfWhatIsOldInStep) {
  Following live;
  live.run(0.0, 6.0);
  LiveColumns& c = live.seen;
  EXPECT_FALSE(c.forget_before(-1.0));
  EXPECT_TRUE(c.forget_before(4.0));
  EXPECT_GE(c.t_s.front(), 4.0);
  EXPECT_GE(c.loadcell_t_s.front(), 4.0);
  for (const auto* column : {&c.torque_nm, &c.low_nm, &c.clock_high_nm, &c.weight, &c.k_nm_per_rad,
                             &c.k_high_nm_per_rad})
    EXPECT_EQ(column->size(), c.t_s.size());
  for (const auto& residuals : c.residuals) EXPECT_EQ(residuals.nm.size(), residuals.t_s.size());
}

}  // namespace
}  // namespace searig::app
