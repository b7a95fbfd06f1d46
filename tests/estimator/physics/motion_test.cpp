#include "estimator/physics/motion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace searig::estimator {
namespace {

/// Cubics in time, which the differentiator gets exactly right; the clock starts at 100 s.
ModuleSignals cubics() {
  ModuleSignals s;
  for (int i = 0; i < 300; ++i) {
    const double t = 0.005 * i;
    s.t_s.push_back(100 + t);
    s.input_angle_rad.push_back(0.3 * t * t * t);
    s.output_angle_rad.push_back(0.1 * t * t);
    s.deflection_rad.push_back(0.3 * t * t * t - 0.1 * t * t);
    s.current_a.push_back(i);
  }
  return s;
}

TEST(MotionOf, StartsAtZeroAndKnowsRatesAndAccelerations) {
  const Motion m = motion_of(cubics(), 0.024);
  ASSERT_EQ(m.size(), 300u);
  EXPECT_EQ(m.t.front(), 0.0);
  for (std::size_t i = 0; i < m.size(); ++i) {
    const double t = m.t[i];
    ASSERT_NEAR(m.w[i], 0.9 * t * t, 1e-7);
    ASSERT_NEAR(m.a[i], 1.8 * t, 1e-5);
    ASSERT_NEAR(m.w_o[i], 0.2 * t, 1e-7);
    ASSERT_NEAR(m.a_o[i], 0.2, 1e-5);
    ASSERT_NEAR(m.theta_rate[i], 0.9 * t * t - 0.2 * t, 1e-7);
    ASSERT_EQ(m.current[i], double(i));
  }
}

TEST(MotionOf, DifferentiatesAnAngleRatherThanTrustingTheReportedVelocity) {
  ModuleSignals s = cubics();
  s.input_velocity_rad_s.assign(300, 7.0);
  EXPECT_NEAR(motion_of(s, 0.024).w[200], 0.9, 1e-7);
  s.input_angle_rad.clear();
  EXPECT_NEAR(motion_of(s, 0.024).w[200], 7.0, 1e-9);
  EXPECT_NEAR(motion_of(s, 0.024).a[200], 0.0, 1e-6);
}

TEST(MotionOf, HasNoDriveWithoutAVelocityAndNoSpringWithoutADeflection) {
  ModuleSignals s = cubics();
  EXPECT_TRUE(motion_of(s, 0.024).has_drive() && motion_of(s, 0.024).has_spring());
  s.input_angle_rad.clear();
  EXPECT_FALSE(motion_of(s, 0.024).has_drive());
  s.deflection_rad.clear();
  EXPECT_FALSE(motion_of(s, 0.024).has_spring());
  EXPECT_EQ(motion_of({}, 0.024).size(), 0u);
}

TEST(ChannelOf, KnowsTheDiagnosissNamesAndWhatIsMissing) {
  const Motion m = motion_of(cubics(), 0.024);
  EXPECT_EQ(channel_of(m, "deflection_rate_rad_s"), &m.theta_rate);
  EXPECT_EQ(channel_of(m, "input_acceleration_rad_s2"), &m.a);
  EXPECT_EQ(channel_of(m, "output_angle_rad"), &m.q_o);
  EXPECT_EQ(channel_of(m, "winding_temperature_c"), nullptr);  // not recorded
  EXPECT_EQ(channel_of(m, "no_such_channel"), nullptr);
}

}  // namespace
}  // namespace searig::estimator
