#include "acquisition/clock/hull.h"

#include <gtest/gtest.h>

#include <random>

namespace searig::acquisition {
namespace {

TEST(LowerHull, KeepsTheCornersBelowAndDropsAllElse) {
  const std::vector<double> x{0, 1, 2, 3, 4}, y{1, 0, 2, -1, 3};
  EXPECT_EQ(lower_hull(x, y), (std::vector<std::size_t>{0, 1, 3, 4}));
}

TEST(LowerHull, TakesOnlyTheEndsOfPointsInLine) {
  const std::vector<double> x{0, 1, 2, 3}, y{0, 1, 2, 3};
  EXPECT_EQ(lower_hull(x, y), (std::vector<std::size_t>{0, 3}));
}

TEST(LowerHull, TakesTheLowestOfPointsAtOneX) {
  const std::vector<double> x{0, 0, 1, 1, 2, 2}, y{3, 2, 0, -1, 5, 4};
  EXPECT_EQ(lower_hull(x, y), (std::vector<std::size_t>{1, 3, 5}));
}

TEST(LineUnder, IsTheLineThatNoisePushedUp) {
  std::vector<double> x, y;
  std::mt19937_64 random(1);
  std::exponential_distribution<double> delay(1.0 / 0.002);
  for (int i = 0; i < 4000; ++i) {
    x.push_back(1e9 + 0.02 * i);  // clocks may count from 1970
    y.push_back(3.0 - 0.005 * (0.02 * i) + delay(random));
  }
  const Line line = line_under(x, y);
  EXPECT_NEAR(line.slope, -0.005, 1e-6);
  EXPECT_NEAR(line(1e9), 3.0, 3e-5);
  for (std::size_t i = 0; i < x.size(); ++i) ASSERT_LE(line(x[i]), y[i] + 1e-9);
}

TEST(LineUnder, IsClosestOnAverageOfAllLinesBelow) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> somewhere(0.0, 1.0);
  std::vector<double> x, y;
  for (int i = 0; i < 60; ++i) {
    x.push_back(i + somewhere(random));
    y.push_back(10.0 * somewhere(random));
  }
  const auto height = [&](const Line& line) {
    double sum = 0.0;
    for (const double at : x) sum += line(at);
    return sum;
  };
  const double best = height(line_under(x, y));
  for (double slope = -1.0; slope <= 1.0; slope += 0.01)
    EXPECT_LE(height(line_under(x, y, slope, 30.0)), best + 1e-9);
}

TEST(LineUnder, OnePointGivesALevelLineThroughIt) {
  const std::vector<double> x{2.0}, y{7.0};
  EXPECT_EQ(line_under(x, y)(100.0), 7.0);
}

}  // namespace
}  // namespace searig::acquisition
