#include "app/report/column_spans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/app/report/noisy_line.h"

namespace searig::app {
namespace {

std::vector<Range> spans_of(const Line& line, Range view, std::size_t columns,
                            Joined joined = Joined::yes) {
  Extremes extremes;
  extremes.follow(line.y);
  std::vector<Range> spans;
  column_spans(line.x, line.y, extremes, view, columns, joined, spans);
  return spans;
}

TEST(Extremes, AreThoseOfEveryStretch) {
  const Line line = noisy_line(5000);
  Extremes extremes;
  extremes.follow(line.y);
  std::mt19937_64 random(3);
  for (int trial = 0; trial < 2000; ++trial) {
    std::size_t first = random() % 5000, last = random() % 5000;
    if (first > last) std::swap(first, last);
    const auto begin = line.y.begin();
    const auto [lowest, highest] = std::minmax_element(
        begin + static_cast<std::ptrdiff_t>(first), begin + static_cast<std::ptrdiff_t>(last + 1));
    const Range found = extremes.in(line.y, first, last + 1);
    ASSERT_EQ(found.low, *lowest);
    ASSERT_EQ(found.high, *highest);
  }
}

TEST(Extremes, FollowAColumnThatGrows) {
  const Line all = noisy_line(30000);
  std::mt19937_64 random(7);
  Extremes extremes;
  std::vector<double> y;
  while (y.size() < all.y.size()) {
    y.assign(all.y.begin(), all.y.begin() + static_cast<std::ptrdiff_t>(std::min(
                                                all.y.size(), y.size() + 1 + random() % 3000)));
    extremes.follow(y);
    const auto [lowest, highest] = std::minmax_element(y.begin(), y.end());
    ASSERT_EQ(extremes.in(y, 0, y.size()).low, *lowest);
    ASSERT_EQ(extremes.in(y, 0, y.size()).high, *highest);
  }
}

TEST(Extremes, SayWhereAValueIsNotFinite) {
  Line line = noisy_line(1000);
  line.y[300] = std::nan("");
  Extremes extremes;
  extremes.follow(line.y);
  EXPECT_TRUE(std::isnan(extremes.in(line.y, 0, 1000).low));
  EXPECT_TRUE(std::isnan(extremes.in(line.y, 300, 301).high));
  EXPECT_FALSE(std::isnan(extremes.in(line.y, 301, 1000).low));
  EXPECT_FALSE(std::isnan(extremes.in(line.y, 0, 300).low));
}

TEST(ColumnSpans, HaveEveryPeakOfEveryColumn) {
  const Line line = noisy_line(100000);
  const auto spans = spans_of(line, {0.0, 100.0}, 500, Joined::no);
  for (std::size_t column = 0; column < spans.size(); ++column) {
    const auto first = line.y.begin() + static_cast<std::ptrdiff_t>(column * 200);
    const auto [lowest, highest] = std::minmax_element(first, first + 200);
    EXPECT_EQ(spans[column].low, *lowest) << column;
    EXPECT_EQ(spans[column].high, *highest) << column;
  }
}

TEST(ColumnSpans, AreWhereTheStraightLinesAre) {
  const Line line{{-1.0, 0.5, 1.5, 9.0}, {-2.0, 1.0, 1.0, 8.5}};
  const auto spans = spans_of(line, {0.0, 4.0}, 8);
  EXPECT_DOUBLE_EQ(spans[0].low, 0.0);  // it comes in from the left
  EXPECT_DOUBLE_EQ(spans[0].high, 1.0);
  EXPECT_DOUBLE_EQ(spans[2].low, 1.0);
  EXPECT_DOUBLE_EQ(spans[2].high, 1.0);
  EXPECT_DOUBLE_EQ(spans[7].low, 3.0);  // and leaves to the right
  EXPECT_DOUBLE_EQ(spans[7].high, 3.5);
}

TEST(ColumnSpans, ADenseLineCoversWhatItsSegmentsCover) {
  const Line line = noisy_line(3000);
  const std::size_t columns = 70;
  const auto spans = spans_of(line, {0.5, 2.5}, columns);
  const double width = 2.0 / double(columns);
  std::vector<Range> slow(columns, {1e9, -1e9});  // by a thousand steps along each segment
  for (std::size_t i = 0; i + 1 < line.x.size(); ++i)
    for (double s = 0.0; s <= 1.0; s += 1e-3) {
      const double column = std::floor((line.x[i] + s * (line.x[i + 1] - line.x[i]) - 0.5) / width);
      if (column < 0.0 || column >= double(columns)) continue;
      const double y = line.y[i] + s * (line.y[i + 1] - line.y[i]);
      Range& range = slow[std::size_t(column)];
      range = {std::min(range.low, y), std::max(range.high, y)};
    }
  for (std::size_t column = 0; column < columns; ++column) {
    EXPECT_NEAR(spans[column].low, slow[column].low, 5e-3) << column;
    EXPECT_NEAR(spans[column].high, slow[column].high, 5e-3) << column;
  }
}

TEST(ColumnSpans, AGapIsLeftOpen) {
  Line line = noisy_line(100);
  for (std::size_t i = 40; i < 60; ++i) line.y[i] = std::nan("");
  const auto spans = spans_of(line, {0.0, 0.1}, 100);
  for (std::size_t column = 0; column < 100; ++column)
    EXPECT_EQ(spans[column].low <= spans[column].high, column < 40 || column >= 60) << column;
}

TEST(ColumnSpans, NothingComesOfNothing) {
  for (const auto& span : spans_of({}, {0.0, 1.0}, 10)) EXPECT_GT(span.low, span.high);
  EXPECT_GT(spans_of({{1.0}, {1.0}}, {1.0, 1.0}, 10)[0].low, 0.0);
}

}  // namespace
}  // namespace searig::app
