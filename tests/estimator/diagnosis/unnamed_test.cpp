#include "estimator/diagnosis/unnamed.h"

#include <gtest/gtest.h>

#include <cmath>

namespace searig::estimator {
namespace {

/// A second of motion whose current is off by `error_a`.
Motion moved(double error_a) {
  Motion m;
  for (int i = 0; i < 300; ++i) {
    const double t = i / 300.0, x = 2 * M_PI * t;
    m.t.push_back(t);
    m.w.push_back(std::cos(x));
    m.current.push_back(2.0 * std::sin(x) + 0.5 * std::sin(3 * x) + error_a);
  }
  m.smoothing_rad_s = 0.01;
  return m;
}

/// Beside a torque constant that grew to match, it would gain without explaining anything.
TEST(Unnamed, NoFunctionOfTheCurrentTakesBackItsErrors) {
  constexpr double error_a = 1e-6;
  const Motion exact = moved(0.0), off = moved(error_a);
  const auto before = unnamed_atoms(exact), after = unnamed_atoms(off);
  ASSERT_EQ(before.size(), after.size());
  int functions = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i].channel != "current_a" && before[i].what != "the motor's torque constant jumps")
      continue;
    ++functions;
    const Eigen::VectorXd same =
        after[i].at ? after[i].at(before[i].from, before[i].to) : after[i].feature;
    const double slope = (same - before[i].feature).mean() / error_a;
    EXPECT_NEAR(slope, 0.0, 0.02) << before[i].what << " from " << before[i].from;
  }
  EXPECT_GT(functions, 20);
}

}  // namespace
}  // namespace searig::estimator
