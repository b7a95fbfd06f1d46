#include "app/report/decimate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/app/report/noisy_line.h"

namespace searig::app {
namespace {

TEST(Decimate, KeepsEveryPeakOfEveryPixelColumn) {
  const Line line = noisy_line(100000);
  const std::size_t columns = 500;
  const double low = 0.0, high = 100.0;
  const auto kept = decimate(line.x, line.y, low, high, columns);
  for (std::size_t column = 0; column < columns; ++column) {
    const auto first = line.y.begin() + static_cast<std::ptrdiff_t>(column * 200);
    const auto [lowest, highest] = std::minmax_element(first, first + 200);
    const auto index = [&](auto it) { return static_cast<std::size_t>(it - line.y.begin()); };
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), index(lowest))) << column;
    EXPECT_TRUE(std::binary_search(kept.begin(), kept.end(), index(highest))) << column;
  }
}

TEST(Decimate, ReturnsNoMoreThanTheScreenShows) {
  const Line line = noisy_line(1000000);
  const auto kept = decimate(line.x, line.y, 100.0, 900.0, 700);
  EXPECT_LE(kept.size(), 4u * 700u + 8u);
  EXPECT_TRUE(std::is_sorted(kept.begin(), kept.end()));
}

TEST(Decimate, KeepsAFewPointsAsTheyAre) {
  const Line line = noisy_line(50);
  EXPECT_EQ(decimate(line.x, line.y, -1.0, 1.0, 100000).size(), 50u);
}

TEST(Decimate, LetsTheLineLeaveThePicture) {
  const Line line = noisy_line(1000);
  const auto kept = decimate(line.x, line.y, 0.251, 0.351, 1000);
  EXPECT_EQ(kept.front(), 250u);
  EXPECT_EQ(kept.back(), 351u);
}

TEST(Decimate, AGapBreaksTheLineOnce) {
  Line line = noisy_line(100);
  for (std::size_t i = 40; i < 60; ++i) line.y[i] = std::nan("");
  const auto kept = decimate(line.x, line.y, 0.0, 0.1, 1000);
  EXPECT_EQ(std::count_if(kept.begin(), kept.end(), [&](auto i) { return std::isnan(line.y[i]); }),
            1);
}

TEST(Decimate, NothingComesOfNothing) {
  EXPECT_TRUE(decimate({}, {}, 0.0, 1.0, 100).empty());
  EXPECT_TRUE(decimate({1.0}, {1.0}, 1.0, 1.0, 100).empty());
}

}  // namespace
}  // namespace searig::app
