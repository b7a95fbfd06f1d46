#include "app/report/scrolling_spans.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/app/report/noisy_line.h"

namespace searig::app {
namespace {

constexpr std::size_t columns = 300;

void expect_as_anew(const ScrollingSpans& scrolling, const Line& line, Range view, Joined joined) {
  Extremes extremes;
  extremes.follow(line.y);
  std::vector<Range> anew;
  column_spans(line.x, line.y, extremes, view, columns, joined, anew);
  ASSERT_EQ(scrolling.spans().size(), columns);
  for (std::size_t i = 0; i < columns; ++i) {
    const Range& kept = scrolling.spans()[i];
    ASSERT_EQ(kept.low <= kept.high, anew[i].low <= anew[i].high) << i;
    if (kept.low > kept.high) continue;
    ASSERT_NEAR(kept.low, anew[i].low, 1e-9) << i;
    ASSERT_NEAR(kept.high, anew[i].high, 1e-9) << i;
  }
}

/// As live: points come, the view goes along; now and then it stands, leaps, or shows less.
void scroll(Joined joined, std::size_t at_most_a_frame) {
  const Line all = noisy_line(30'000);
  std::mt19937_64 random(5);
  Line line;
  Extremes extremes;
  ScrollingSpans scrolling;
  double share = 0.2;  // of all that is shown
  for (int frame = 0; line.x.size() < all.x.size(); ++frame) {
    const std::size_t more = random() % at_most_a_frame;
    for (std::size_t i = 0; i < more && line.x.size() < all.x.size(); ++i) {
      line.y.push_back(all.y[line.x.size()]);
      line.x.push_back(all.x[line.x.size()]);
    }
    if (frame % 17 == 16) share = 0.05 + 0.001 * double(random() % 200);
    extremes.follow(line.y);
    const double now = line.x.empty() ? 0.0 : line.x.back();
    const double end = frame % 11 == 10 ? 0.5 * now : now;
    const Range view = snapped({end - share * all.x.back(), end}, columns);
    scrolling.follow(line.x, line.y, extremes, view, columns, joined);
    expect_as_anew(scrolling, line, view, joined);
    if (testing::Test::HasFatalFailure()) FAIL() << "frame " << frame;
  }
}

TEST(ScrollingSpans, AreThoseThatWouldBeFoundAnew) {
  for (const Joined joined : {Joined::yes, Joined::no})
    for (const std::size_t at_most : {30, 200, 900}) scroll(joined, at_most);
}

TEST(ScrollingSpans, SnapToColumnsThatStay) {
  const Range a = snapped({0.123, 10.123}, 100), b = snapped({0.16, 10.16}, 100);
  EXPECT_NEAR(a.low, 0.1, 1e-12);
  EXPECT_NEAR(b.low, 0.2, 1e-12);
  EXPECT_NEAR(b.high - b.low, 10.0, 1e-12);
}

}  // namespace
}  // namespace searig::app
