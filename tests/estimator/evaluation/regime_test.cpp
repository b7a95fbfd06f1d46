#include "estimator/evaluation/regime.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace searig::estimator {
namespace {

/// A sine of 1 Hz at 1 kHz: velocity, torque and current as they are given.
std::map<Regime, int> counts_of(double (*velocity)(double), double (*torque)(double),
                                double (*current)(double)) {
  RegimeFinder finder;
  std::map<Regime, int> counts;
  for (int i = 0; i < 4000; ++i) {
    const double t = 1e-3 * i;
    ++counts[finder.take(t, velocity(t), torque(t), current(t))];
  }
  return counts;
}

double sine(double t) {
  return std::sin(2.0 * M_PI * t);
}
double still(double) {
  return 0.01;
}
double minus_sine(double t) {
  return -sine(t);
}
double clipped(double t) {
  return std::fmin(0.5, std::fmax(-0.5, sine(t)));
}

TEST(Regime, ATrainThatStandsSticks) {
  EXPECT_EQ(counts_of(still, sine, sine)[Regime::sticking], 4000);
}

TEST(Regime, WorkGivenIsDrivingAndWorkTakenIsBackDriven) {
  auto with = counts_of(sine, sine, sine);
  EXPECT_GT(with[Regime::driving], 2900);
  EXPECT_EQ(with[Regime::back_driven], 0);
  auto against = counts_of(sine, minus_sine, sine);
  EXPECT_GT(against[Regime::back_driven], 2900);
  EXPECT_EQ(against[Regime::driving], 0);
}

TEST(Regime, AfterATurnItReversesForATenthOfASecond) {
  // Seven turns in four periods, 100 ms each.
  EXPECT_NEAR(counts_of(sine, sine, sine)[Regime::reversing], 700, 10);
}

TEST(Regime, ACurrentHeldAtItsLargestIsSaturatedAndAPeakIsNot) {
  // Beyond half of the amplitude for two thirds of the time, but for 50 ms eight times.
  EXPECT_NEAR(counts_of(sine, sine, clipped)[Regime::saturated], 2667 - 8 * 50, 20);
  EXPECT_EQ(counts_of(sine, sine, sine)[Regime::saturated], 0);
}

}  // namespace
}  // namespace searig::estimator
