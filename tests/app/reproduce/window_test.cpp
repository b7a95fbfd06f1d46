#include "app/reproduce/window.h"

#include <gtest/gtest.h>

#include <cmath>

namespace searig::app::reproduce {
namespace {

Window falling() {
  Window window;
  window.t_s = {0, 1, 2, 3, 4};
  window.stiffness_nm_per_rad = {400, 100, 46, 41, 43};
  return window;
}

TEST(Window, SettlesWhereItStaysForGood) {
  EXPECT_EQ(settled_s(falling(), 40, 0.2), 2);
  EXPECT_EQ(settled_s(falling(), 40, 0.1), 3);
  EXPECT_TRUE(std::isinf(settled_s(falling(), 40, 0.05)));  // it left again at the end
  EXPECT_EQ(settled_s(falling(), 40, 10), 0);
}

TEST(Window, ErrorIsOverTheMeanMagnitudeFromATimeOn) {
  Window window;
  window.measured_t_s = {0, 1, 2};
  window.measured_nm = {2, -2, 2};
  EXPECT_DOUBLE_EQ(error_percent(window, {1, 0, -1}, 0), 100.0 * 2 / 6);
  EXPECT_DOUBLE_EQ(error_percent(window, {1, 0, -1}, 0.5), 100.0 * 1 / 4);
}

}  // namespace
}  // namespace searig::app::reproduce
