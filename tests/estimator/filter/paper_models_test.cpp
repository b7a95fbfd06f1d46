#include "estimator/filter/paper_models.h"

#include <gtest/gtest.h>

#include <vector>

namespace searig::estimator {
namespace {

TEST(TrustWeight, GammaIs20InDegreesAndSeconds) {
  const double degree = std::numbers::pi / 180;
  EXPECT_NEAR(paper_gamma_rad2_per_s, 0.006092348, 1e-9);
  // 4 degrees, growing by 2.5 degrees per second: 10 of 20.
  EXPECT_NEAR(trust_weight(4 * degree, 2.5 * degree, paper_gamma_rad2_per_s), 0.5, 1e-12);
}

TEST(TrustWeight, IsForADeflectionThatGrowsEitherWay) {
  EXPECT_EQ(trust_weight(2, 3, 60), 0.1);
  EXPECT_EQ(trust_weight(-2, -3, 60), 0.1);
  EXPECT_EQ(trust_weight(2, 300, 60), 1);
}

TEST(TrustWeight, IsZeroForADeflectionThatShrinksOrRests) {
  EXPECT_EQ(trust_weight(2, -3, 60), 0);
  EXPECT_EQ(trust_weight(-2, 3, 60), 0);
  EXPECT_EQ(trust_weight(2, 0, 60), 0);
  EXPECT_EQ(trust_weight(0, 3, 60), 0);
}

TEST(SquaredError, ComparesDriveAndSpring) {
  EXPECT_DOUBLE_EQ(squared_error({.theta = 0.1, .drive_torque = 8, .weight = 0.5}, 50), 4.5);
}

TEST(MeanSquaredError, IsTheWeightedAverageOverItsSamples) {
  const std::vector<WeightedSample> samples{{0.1, 8, 0.5}, {0.2, 9, 1}, {0.3, 99, 0}};
  EXPECT_DOUBLE_EQ(mean_squared_error(samples, 50), (4.5 + 1 + 0) / 3);
  EXPECT_DOUBLE_EQ(mean_squared_error(std::span(samples).first(1), 50), 4.5);
}

TEST(ProcessNoise, IsAShareOfTheStiffness) {
  EXPECT_DOUBLE_EQ(process_noise(paper_alpha, 50), 0.005);
}

}  // namespace
}  // namespace searig::estimator
