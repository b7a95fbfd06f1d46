#include "app/desktop/plot/time_plot.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/app/desktop/offscreen.h"

namespace searig::app::desktop {
namespace {

/// A stiffness that was guessed ten times too high, and hardly moves once it is found.
struct Found {
  std::vector<double> t_s, k;

  Found() {
    for (int i = 0; i <= 6000; ++i) {
      t_s.push_back(0.01 * i);
      k.push_back(40.0 + 360.0 * std::exp(-t_s.back()) + 0.2 * std::sin(t_s.back()));
    }
  }
};

class TimePlotTest : public testing::Test {
 protected:
  TimePlotTest() {
    plot_.resize(800, 200);
    plot_.set_data(plot_.add_curve({}, Hue::green), &found_.t_s, &found_.k);
    plot_.follow_y_about(found_.k.back());
    plot_.show_range({0.0, 60.0});
  }

  QApplication& application_ = offscreen_application();
  const Found found_;
  TimePlot plot_{QStringLiteral("k"), QStringLiteral("k (N·m/rad)")};
};

TEST_F(TimePlotTest, AFirstGuessFarAwayFlattensNothing) {
  EXPECT_LT(plot_.y_range().high, 65.0);
  EXPECT_GT(plot_.y_range().high, 55.0);
}

TEST_F(TimePlotTest, ComesCloseToWhatHardlyMovesButNotToItsNoise) {
  plot_.show_range({30.0, 60.0});
  const Range shown = plot_.y_range();
  EXPECT_LT(shown.low, 39.8);
  EXPECT_GT(shown.high, 40.2);
  EXPECT_NEAR(shown.high - shown.low, 1.2 * 0.1 * 40.0, 0.1);
}

}  // namespace
}  // namespace searig::app::desktop
