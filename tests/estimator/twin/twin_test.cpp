#include "estimator/twin/twin.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace searig::estimator::twin {
namespace {

TEST(Twin, TheSameSeedIsTheSameExperiment) {
  Twin one({}, 7), other({}, 7), different({}, 8);
  for (auto* twin : {&one, &different}) twin->advance_to(4.0);
  for (double t = 0.0; t < 4.0; t += 0.00123) other.advance_to(t);  // in other steps
  other.advance_to(4.0);
  EXPECT_EQ(one.state().output_angle_rad, other.state().output_angle_rad);
  EXPECT_EQ(one.state().spring_torque_nm, other.state().spring_torque_nm);
  EXPECT_EQ(one.read_module().input_angle_rad, other.read_module().input_angle_rad);
  EXPECT_EQ(one.read_loadcell().force_n, other.read_loadcell().force_n);
  EXPECT_NE(one.state().output_angle_rad, different.state().output_angle_rad);
}

TEST(Twin, ReadingOneSensorLeavesTheOtherAlone) {
  Twin read_often, read_once;
  for (auto* twin : {&read_often, &read_once}) twin->advance_to(1.0);
  for (int i = 0; i < 100; ++i) read_often.read_module();
  EXPECT_EQ(read_often.read_loadcell().force_n, read_once.read_loadcell().force_n);
}

TEST(Twin, TheLoadCellReadsTheTorqueOverItsArm) {
  Parameters parameters;
  parameters.sensors.force_noise_n = 0.0;
  parameters.sensors.force_step_n = 0.0;
  Twin twin(parameters);
  for (double t = 2.0; t < 12.0; t += 0.1) {
    twin.advance_to(t);
    const double torque = twin.read_loadcell().force_n * parameters.lever.arm_m;
    EXPECT_DOUBLE_EQ(torque, -twin.state().hand_torque_nm);
    // The lever is light: what the spring gives reaches the hand but for its inertia.
    EXPECT_NEAR(torque, twin.state().spring_torque_nm, 0.15);
  }
}

TEST(Twin, LoadsTheSpringAsThePaperDoes) {
  Twin twin;
  double largest = 0.0;
  for (double t = 0.0; t < 60.0; t += 0.01) {
    twin.advance_to(t);
    largest = std::max(largest, std::abs(twin.state().spring_torque_nm));
    EXPECT_LT(std::abs(twin.state().output_angle_rad), 1.6);  // +-90 degrees, section III
    EXPECT_LE(std::abs(twin.current_a()), 3.5);
  }
  EXPECT_GT(largest, 4.0);
  EXPECT_LT(largest, 9.0);
}

}  // namespace
}  // namespace searig::estimator::twin
