#include "app/report/axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace searig::app {
namespace {

TEST(Axis, TicksAreRoundAndWithin) {
  const Axis axis = make_axis({-0.13, 1.26}, 5);
  ASSERT_GE(axis.ticks.size(), 3u);
  for (const double tick : axis.ticks) {
    EXPECT_GE(tick, -0.13);
    EXPECT_LE(tick, 1.26);
    EXPECT_NEAR(std::remainder(tick, 0.1), 0.0, 1e-9);
  }
}

TEST(Axis, TicksAtBothEndsStay) {
  const Axis axis = make_axis({0.0, 0.3}, 3);
  EXPECT_DOUBLE_EQ(axis.ticks.front(), 0.0);
  EXPECT_DOUBLE_EQ(axis.ticks.back(), 0.3);
}

TEST(Axis, LabelsTellTicksApart) {
  for (const Range range : {Range{437.5, 437.5004}, Range{-7, 7}, Range{0, 2e7}, Range{0, 3e-6},
                            Range{-1e-12, 1e-12}, Range{1e5, 1.0001e5}}) {
    const Axis axis = make_axis(range, 6);
    std::set<std::string> labels;
    for (const double tick : axis.ticks) labels.insert(axis.label(tick));
    EXPECT_GE(labels.size(), 3u) << range.low;
    EXPECT_EQ(labels.size(), axis.ticks.size()) << range.low;
  }
}

TEST(Axis, NoRangeIsTooStrange) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const Range range : {Range{5, 5}, Range{0, 0}, Range{1, -1}, Range{-inf, inf},
                            Range{std::nan(""), 1}, Range{1e300, 1e300}}) {
    const Axis axis = make_axis(range, 5);
    EXPECT_LT(axis.range.low, axis.range.high);
    EXPECT_LT(axis.ticks.size(), 50u);
  }
}

TEST(Axis, NumbersAreWrittenForPeople) {
  EXPECT_EQ(number(-1.5, 1), "−1.5");
  EXPECT_EQ(number(-0.001, 1), "0.0");  // no minus before nothing
  EXPECT_EQ(number(std::nan(""), 1), "–");
}

TEST(Axis, SpanLeavesOutWhatIsNotFinite) {
  const std::vector<double> values{1.0, std::nan(""), 3.0, std::numeric_limits<double>::infinity()};
  const Range span = span_of({&values}, 0.5);
  EXPECT_DOUBLE_EQ(span.low, 0.0);
  EXPECT_DOUBLE_EQ(span.high, 4.0);
}

}  // namespace
}  // namespace searig::app
