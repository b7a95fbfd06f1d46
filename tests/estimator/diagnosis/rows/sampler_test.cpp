#include "estimator/diagnosis/rows/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace searig::estimator {
namespace {

std::vector<double> uneven_times(int n) {
  std::mt19937 random(7);
  std::vector<double> t{0.0};
  for (int i = 1; i < n; ++i)
    t.push_back(t.back() + std::uniform_real_distribution(0.002, 0.008)(random));
  return t;
}

Eigen::VectorXd each(const std::vector<double>& t, auto f) {
  Eigen::VectorXd out(Eigen::Index(t.size()));
  for (std::size_t i = 0; i < t.size(); ++i) out[Eigen::Index(i)] = f(t[i]);
  return out;
}

const std::vector<double> centres{0.1, 0.1234, 0.5, 0.777, 1.0};

TEST(Sampler, AveragesAStraightLineToItsValueInTheMiddle) {
  const auto t = uneven_times(300);
  const auto line = [](double x) { return 3.0 - 2.0 * x; };
  for (const double width : {0.02, 0.0031, 0.1}) {
    const Eigen::VectorXd got = Sampler(t, centres, width)(each(t, line));
    for (std::size_t i = 0; i < centres.size(); ++i)
      EXPECT_NEAR(got[Eigen::Index(i)], line(centres[i]), 1e-12);
  }
}

TEST(Sampler, AveragesAParabolaOverItsWindow) {
  std::vector<double> t;
  for (int i = 0; i <= 20000; ++i) t.push_back(1e-4 * i);
  const Eigen::VectorXd got = Sampler(t, centres, 0.1)(each(t, [](double x) { return 5 * x * x; }));
  for (std::size_t i = 0; i < centres.size(); ++i)  // the mean of x^2 is c^2 + width^2/12
    EXPECT_NEAR(got[Eigen::Index(i)], 5 * (centres[i] * centres[i] + 0.01 / 12), 1e-7);
}

TEST(Sampler, IsTheIntegralOfTheLinesBetweenSamples) {
  const auto t = uneven_times(300);
  std::mt19937 random(3);
  std::normal_distribution<double> gauss;
  const Eigen::VectorXd x = each(t, [&](double) { return gauss(random); });
  const Eigen::VectorXd got = Sampler(t, centres, 0.05)(x);
  for (std::size_t c = 0; c < centres.size(); ++c) {
    constexpr int n = 200000;
    double sum = 0.0;
    std::size_t j = 0;
    for (int s = 0; s < n; ++s) {
      const double at = centres[c] - 0.025 + 0.05 * (s + 0.5) / n;
      while (t[j + 1] < at) ++j;
      const double u = (at - t[j]) / (t[j + 1] - t[j]);
      sum += x[Eigen::Index(j)] * (1 - u) + x[Eigen::Index(j) + 1] * u;
    }
    EXPECT_NEAR(got[Eigen::Index(c)], sum / n, 1e-6);
  }
}

TEST(Sampler, IsCurvedWhereTheWindowIsShorterThanAStep) {
  const auto t = uneven_times(300);
  for (const double width : {0.004, 0.001}) {
    const Eigen::VectorXd got = Sampler(t, centres, width)(each(t, [](double x) { return x * x; }));
    for (std::size_t i = 0; i < centres.size(); ++i)  // the mean of x^2 is c^2 + width^2/12
      EXPECT_NEAR(got[Eigen::Index(i)], centres[i] * centres[i] + width * width / 12, 1e-12);
  }
}

TEST(Sampler, LooksLaterByItsShift) {
  const auto t = uneven_times(300);
  const auto line = [](double x) { return 3.0 - 2.0 * x; };
  const Eigen::VectorXd got = Sampler(t, centres, 0.02, 0.05)(each(t, line));
  EXPECT_NEAR(got[2], line(0.55), 1e-12);
}

TEST(Sampler, TakesColumnsOneByOne) {
  const auto t = uneven_times(300);
  const Sampler sampler(t, centres, 0.02);
  Eigen::MatrixXd both(300, 2);
  both << each(t, [](double x) { return std::sin(x); }), each(t, [](double x) { return x * x; });
  EXPECT_EQ(sampler.columns(both).col(0), sampler(both.col(0)));
  EXPECT_EQ(sampler.columns(both).col(1), sampler(both.col(1)));
}

TEST(Sampler, CoversNeitherHolesNorWhatLiesBeyondTheEnds) {
  std::vector<double> t;
  for (int i = 0; i <= 100; ++i)
    if (i < 40 || i > 60) t.push_back(0.01 * i);
  const Sampler sampler(t, {0.0, 0.02, 0.2, 0.385, 0.5, 0.62, 0.99, 1.0, 1.5}, 0.02);
  EXPECT_EQ(sampler.covered(0.05),
            (std::vector<bool>{false, true, true, false, false, true, true, false, false}));
  EXPECT_TRUE(sampler.covered(0.5)[4]);
}

}  // namespace
}  // namespace searig::estimator
