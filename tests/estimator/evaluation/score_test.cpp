#include "estimator/evaluation/score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace searig::estimator {
namespace {

const double nan = std::nan("");

TEST(Score, IsTheMeanErrorOverTheMeanMeasured) {
  const std::vector<double> estimate{1.5, -2, 3}, measured{1, -2, 4};
  const Score result = score(estimate, measured);
  EXPECT_DOUBLE_EQ(result.error_percent, 100 * 1.5 / 7);
  EXPECT_DOUBLE_EQ(result.rmse_nm, std::sqrt(1.25 / 3));
}

TEST(Score, LeavesOutWhatIsNoNumber) {
  const std::vector<double> estimate{1.5, nan, 3, 7}, measured{1, -2, 4, nan};
  EXPECT_DOUBLE_EQ(score(estimate, measured).error_percent, 100 * 1.5 / 5);
}

TEST(Score, OfNothingIsNoNumber) {
  EXPECT_TRUE(std::isnan(score({}, {}).error_percent));
  EXPECT_TRUE(std::isnan(score({}, {}).rmse_nm));
  const std::vector<double> estimate{1, 1}, silence{0, 0};
  EXPECT_TRUE(std::isnan(score(estimate, silence).error_percent));
  EXPECT_DOUBLE_EQ(score(estimate, silence).rmse_nm, 1);
}

TEST(FitLine, GoesThroughPointsOnALine) {
  const std::vector<double> x{0, 1, 2, 5}, y{3, 5, 7, 13};
  const Line line = fit_line(x, y);
  EXPECT_NEAR(line.slope, 2, 1e-14);
  EXPECT_NEAR(line.offset, 3, 1e-14);
}

TEST(FitLine, IsTheLeastSquaresLine) {
  const std::vector<double> x{0, 1, 2}, y{0, 0, 3};
  const Line line = fit_line(x, y);
  EXPECT_NEAR(line.slope, 1.5, 1e-14);
  EXPECT_NEAR(line.offset, -0.5, 1e-14);
}

TEST(FitLine, TakesWeights) {
  const std::vector<double> x{0, 1, 2, 3}, y{1, 2, 3, 100}, weights{1, 2, 0.5, 0};
  const Line line = fit_line(x, y, weights);
  EXPECT_NEAR(line.slope, 1, 1e-14);
  EXPECT_NEAR(line.offset, 1, 1e-14);
}

TEST(FitLine, LosesNoDigitsToALargeCommonPart) {
  std::vector<double> x, y;
  for (int i = 0; i < 100; ++i) {
    x.push_back(1e6 + 0.01 * i);
    y.push_back(3 * 0.01 * i);
  }
  EXPECT_NEAR(fit_line(x, y).slope, 3, 1e-6);
}

TEST(FitLine, HasNoSlopeWhereNothingVariesOrNothingIsThere) {
  EXPECT_TRUE(
      std::isnan(fit_line(std::vector<double>{2, 2, 2}, std::vector<double>{1, 2, 3}).slope));
  EXPECT_TRUE(std::isnan(fit_line(std::vector<double>{nan}, std::vector<double>{1}).slope));
  EXPECT_TRUE(std::isnan(fit_line({}, {}).slope));
}

}  // namespace
}  // namespace searig::estimator
