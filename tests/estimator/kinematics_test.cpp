#include "estimator/kinematics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace searig::estimator {
namespace {

double cubic(double t) {
  return 0.4 - 1.3 * t + 2.1 * t * t - 0.9 * t * t * t;
}
double slope(double t) {
  return -1.3 + 4.2 * t - 2.7 * t * t;
}
double bend(double t) {
  return 4.2 - 5.4 * t;
}

std::vector<double> uneven_times(int n, double mean_step) {
  std::mt19937 random(4);
  std::vector<double> t{0.0};
  for (int i = 1; i < n; ++i)
    t.push_back(t.back() + mean_step * std::uniform_real_distribution(0.3, 1.7)(random));
  return t;
}

std::vector<double> each(const std::vector<double>& t, double (*f)(double)) {
  std::vector<double> out;
  for (const double x : t) out.push_back(f(x));
  return out;
}

TEST(LocalCubic, IsExactOnACubicWithUnevenSamples) {
  const auto t = uneven_times(12, 0.1);
  const auto x = each(t, cubic);
  for (const double at : {t.front(), 0.37, t.back()}) {
    const Derivatives d = local_cubic(t, x, at);
    EXPECT_NEAR(d.value, cubic(at), 1e-11);
    EXPECT_NEAR(d.first, slope(at), 1e-10);
    EXPECT_NEAR(d.second, bend(at), 1e-8);
  }
}

TEST(LocalCubic, LosesNoDigitsToALargeAngleOrALateClock) {
  auto t = uneven_times(24, 0.002);
  auto x = each(t, cubic);
  const double at = t[11];
  for (double& v : t) v += 1e5;
  for (double& v : x) v += 1e4;
  const Derivatives d = local_cubic(t, x, t[11]);
  EXPECT_NEAR(d.first, slope(at), 1e-6);
  EXPECT_NEAR(d.second, bend(at), 1e-2);
}

TEST(LocalCubic, FallsBackToTheLineThroughTheEnds) {
  const std::vector<double> t{1, 2, 4}, x{3, 9, 9};
  const Derivatives d = local_cubic(t, x, 2);
  EXPECT_DOUBLE_EQ(d.value, 5);
  EXPECT_DOUBLE_EQ(d.first, 2);
  EXPECT_DOUBLE_EQ(d.second, 0);
  const std::vector<double> one{1}, value{7};
  EXPECT_DOUBLE_EQ(local_cubic(one, value, 1).value, 7);
  EXPECT_DOUBLE_EQ(local_cubic(one, value, 1).first, 0);
  EXPECT_DOUBLE_EQ(local_cubic({}, {}, 1).value, 0);
}

TEST(Differentiate, IsExactOnACubicFromTheFirstSampleToTheLast) {
  const auto t = uneven_times(400, 0.004);
  const auto k = differentiate(t, each(t, cubic), 0.024);
  for (std::size_t i = 0; i < t.size(); ++i) {
    ASSERT_NEAR(k.value[i], cubic(t[i]), 1e-10);
    ASSERT_NEAR(k.first[i], slope(t[i]), 1e-8);
    ASSERT_NEAR(k.second[i], bend(t[i]), 1e-5);
  }
}

TEST(Differentiate, TakesNeighboursInWhereTheWindowIsEmpty) {
  const std::vector<double> t{0, 0.1, 0.2, 0.3, 2.0, 3.7, 3.8, 3.9, 4.0};
  const auto k = differentiate(t, each(t, cubic), 0.01);
  EXPECT_NEAR(k.first[4], slope(2.0), 1e-8);
  EXPECT_NEAR(k.first[0], slope(0.0), 1e-8);
  EXPECT_NEAR(k.first[8], slope(4.0), 1e-8);
}

TEST(Differentiate, DoesNotShiftASineInTimeAndHardlyWeakensIt) {
  std::vector<double> t, x;
  for (int i = 0; i < 2000; ++i) {
    t.push_back(0.002 * i);
    x.push_back(std::sin(2 * M_PI * 2 * t.back()));
  }
  const auto k = differentiate(t, x, 0.024);
  for (std::size_t i = 50; i < 1950; ++i)
    ASSERT_NEAR(k.first[i], 4 * M_PI * std::cos(4 * M_PI * t[i]), 0.003 * 4 * M_PI);
}

}  // namespace
}  // namespace searig::estimator
