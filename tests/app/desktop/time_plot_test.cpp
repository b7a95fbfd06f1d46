#include "app/desktop/plot/time_plot.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(TimePlot, AFirstGuessFarAwayFlattensNothing) {
  const Found found;
  TimePlot plot(QStringLiteral("k"), QStringLiteral("k (N·m/rad)"));
  plot.resize(800, 200);
  plot.set_data(plot.add_curve({}, Hue::green), &found.t_s, &found.k);
  plot.follow_y_about(found.k.back());
  plot.show_range({0.0, 60.0});
  EXPECT_LT(plot.y_range().high, 65.0);
  EXPECT_GT(plot.y_range().high, 55.0);
}

TEST(TimePlot, ComesCloseToWhatHardlyMovesButNotToItsNoise) {
  const Found found;
  TimePlot plot(QStringLiteral("k"), QStringLiteral("k (N·m/rad)"));
  plot.resize(800, 200);
  plot.set_data(plot.add_curve({}, Hue::green), &found.t_s, &found.k);
  plot.follow_y_about(found.k.back());
  plot.show_range({0.0, 60.0});
  plot.show_range({30.0, 60.0});
  const Range shown = plot.y_range();
  EXPECT_LT(shown.low, 39.8);
  EXPECT_GT(shown.high, 40.2);
  EXPECT_NEAR(shown.high - shown.low, 1.2 * 0.1 * 40.0, 0.1);
}

}  // namespace
}  // namespace searig::app::desktop
