// Where drive.ripple looks for waves, and what its model file may say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "estimator/model/model.h"
#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

/// Turns at 0.04 rad/s for 100 s, 100 samples per second.
Motion turning(double gear_ratio) {
  Motion m;
  m.gear_ratio = gear_ratio;
  for (int i = 0; i < 10000; ++i) {
    m.t.push_back(0.01 * i);
    m.q_i.push_back(0.04 * m.t.back());
    m.w.push_back(0.04);
    m.current.push_back(1.0);
  }
  return m;
}

bool looks_for(const Motion& motion, double cycles_per_rad) {
  return std::ranges::any_of(find_effect("drive.ripple")->shape_grid(motion), [&](const auto& s) {
    return std::abs(s[0] - cycles_per_rad) < 0.4;  // a quarter wave over 4 rad
  });
}

TEST(Ripple, IsLookedForAtEveryWholeNumberOfWavesPerMotorTurn) {
  const Motion motion = turning(9.0);
  for (const double per_turn : {1.0, 21.0, 42.0, 84.0, 126.0})
    EXPECT_TRUE(looks_for(motion, 9.0 * per_turn)) << per_turn;
  EXPECT_FALSE(looks_for(turning(1.0), 378.0));
}

TEST(Ripple, IsNotLookedForWhereSamplesDoNotResolveIt) {
  Motion fast = turning(9.0);
  for (double& w : fast.w) w *= 50.0;
  for (double& q : fast.q_i) q *= 50.0;
  EXPECT_FALSE(looks_for(fast, 9.0 * 126.0));
}

TEST(Ripple, NeedsAllThreeNumbersOfAWave) {
  const auto complaint = [](const std::string& extra) -> std::string {
    try {
      parse_model(
          "format = \"searig-model/1\"\n[drive.ripple]\ntorque_nm = 0.2\n"
          "cycles_per_rad = 12.0\nphase_rad = 0.5\n" +
              extra,
          "m");
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(complaint(""), "");
  EXPECT_NE(complaint("torque2_nm = 0.1\n").find("needs all of torque2_nm"), std::string::npos);
  EXPECT_NE(
      complaint("torque3_nm = 0.1\ncycles3_per_rad = 9.0\nphase3_rad = 0.0\n").find("before it"),
      std::string::npos);
}

}  // namespace
}  // namespace searig::estimator
