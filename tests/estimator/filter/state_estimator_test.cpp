// Filters of several states: unbiased, free of allocation, and honest about what they do not know.
#include "estimator/filter/state_estimator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace searig::estimator {

extern bool counting_allocations;
extern int counted_allocations;

namespace {

constexpr double truth[] = {80, 20, 5};
const std::vector<std::string> names = {"spring.linear", "spring.cubic", "spring.viscous"};

SpringStates first(int n) {
  return SpringStates({names.begin(), names.begin() + n});
}

// The stream of the notes on code bases, B1: k = 80, and terms of 20 and 5 in units of the
// deflection's amplitude. Its regressors stand for theta, theta^3 and theta'.
template <class Step>
void stream(int n, int steps, Step&& step, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (int i = 0; i < steps; ++i) {
    const double A = 0.15, phase = 2 * M_PI * 0.5 * (i % 4096) / 1000.0;
    const double theta = A * std::sin(phase);
    const double phi[] = {theta, std::pow(theta, 3) / (A * A), A * std::cos(phase)};
    double T = 0.05 * normal(random);
    for (int j = 0; j < n; ++j) T += truth[j] * phi[j];
    step(StateSample{0.001, theta, T, 1, true, {phi, static_cast<std::size_t>(n)}});
  }
}

std::vector<double> estimate(EstimatorKind kind, int n, double initial_k, unsigned seed = 1) {
  const auto filter = make_state_estimator(
      kind, first(n), {.initial_k_nm_per_rad = initial_k, .drift_per_minute = 0.01});
  stream(
      n, 16384 * 8, [&](const StateSample& sample) { filter->step(sample); }, seed);
  std::vector<double> x(static_cast<std::size_t>(n));
  filter->state(x);
  return x;
}

class EveryEstimator : public testing::TestWithParam<EstimatorKind> {};

// The mean of 30 seeds is the truth within what 30 seeds can tell: four standard errors of that
// mean, and a share of the term's own size that no user would see.
TEST_P(EveryEstimator, IsUnbiasedForOneToThreeStates) {
  constexpr unsigned seeds = 30;
  for (int n = 1; n <= 3; ++n) {
    double sum[3] = {}, squares[3] = {};
    for (unsigned seed = 1; seed <= seeds; ++seed) {
      const auto x = estimate(GetParam(), n, 50, seed);
      for (int i = 0; i < n; ++i) {
        const double error = x[static_cast<std::size_t>(i)] - truth[i];
        sum[i] += error, squares[i] += error * error;
      }
    }
    for (int i = 0; i < n; ++i) {
      const double mean = sum[i] / seeds;
      const double sd = std::sqrt(squares[i] / seeds - mean * mean);
      std::printf("%-8s n = %d %-16s bias %8.4f, spread %7.4f\n", name_of(GetParam()).data(), n,
                  names[static_cast<std::size_t>(i)].c_str(), mean, sd);
      EXPECT_LT(std::abs(mean), 4 * sd / std::sqrt(seeds) + 0.002 * truth[0]) << names[i];
      EXPECT_LT(sd, 0.03 * truth[0]) << names[i];
    }
  }
}

TEST_P(EveryEstimator, FindsTheStiffnessFromATenfoldWrongStart) {
  for (const double factor : {0.1, 10.0}) {
    EXPECT_NEAR(estimate(GetParam(), 1, factor * 80)[0], 80, 0.8) << factor;
  }
}

TEST_P(EveryEstimator, AllocatesNothingInAStep) {
  const auto filter = make_state_estimator(GetParam(), first(3), {.initial_k_nm_per_rad = 50});
  counted_allocations = 0, counting_allocations = true;
  stream(3, 60000, [&](const StateSample& sample) { filter->step(sample); });
  counting_allocations = false;
  EXPECT_EQ(counted_allocations, 0);
}

TEST_P(EveryEstimator, IsLeftAloneByWhatIsNotANumber) {
  const auto filter = make_state_estimator(GetParam(), first(2), {.initial_k_nm_per_rad = 50});
  stream(2, 4096, [&](const StateSample& sample) { filter->step(sample); });
  double before[2], after[2];
  filter->state(before);
  const double bad[] = {std::nan(""), 1}, good[] = {0.1, 0.1};
  filter->step({0.001, 0.1, 1, 1, true, bad});
  filter->step({0.001, 0.1, HUGE_VAL, 1, true, good});
  filter->state(after);
  EXPECT_EQ(before[0], after[0]);
  EXPECT_EQ(before[1], after[1]);
}

// The square has no slope where the parameters are right: its P is no interval, and none is given.
TEST_P(EveryEstimator, GivesAnIntervalOnlyWhereItMeansSomething) {
  const auto filter = make_state_estimator(GetParam(), first(1), {.initial_k_nm_per_rad = 50});
  EXPECT_FALSE(filter->covariance().has_value());
  stream(1, 16384, [&](const StateSample& sample) { filter->step(sample); });
  const bool linear = GetParam() == EstimatorKind::linear || GetParam() == EstimatorKind::rls;
  EXPECT_EQ(filter->covariance().has_value(), linear);
}

INSTANTIATE_TEST_SUITE_P(All, EveryEstimator,
                         testing::Values(EstimatorKind::paper, EstimatorKind::moments,
                                         EstimatorKind::linear, EstimatorKind::rls),
                         [](const auto& one) { return std::string(name_of(one.param)); });

// White noise of a known size: the interval is that of least squares, s^2/sum(theta^2).
TEST(LeastSquaresEstimator, HasTheIntervalOfLeastSquaresForWhiteNoise) {
  const auto filter =
      make_state_estimator(EstimatorKind::rls, first(1), {.initial_k_nm_per_rad = 50});
  double theta2 = 0;
  stream(1, 16384 * 4, [&](const StateSample& sample) {
    filter->step(sample);
    theta2 += sample.theta * sample.theta;
  });
  const auto known = filter->covariance();
  ASSERT_TRUE(known);
  EXPECT_NEAR(std::sqrt(known->covariance(0, 0)) / (0.05 / std::sqrt(theta2)), 1, 0.3);
}

TEST(StateEstimator, RefusesWhatMakesNoSense) {
  const SpringStates one = first(1);
  EXPECT_THROW(make_state_estimator(EstimatorKind::rls, one, {}), std::invalid_argument);
  EXPECT_THROW(make_state_estimator(EstimatorKind::linear, one,
                                    {.initial_k_nm_per_rad = 1, .recovery_s = 0}),
               std::invalid_argument);
  const SpringStates softening({"spring.linear", "spring.mullins"});
  EXPECT_THROW(make_state_estimator(EstimatorKind::rls, softening, {.initial_k_nm_per_rad = 1}),
               std::invalid_argument);
}

// Tables of Student's distribution.
TEST(Student, IsTheTabulatedQuantile) {
  EXPECT_NEAR(student_95(3), 3.182, 0.02);
  EXPECT_NEAR(student_95(5), 2.571, 0.003);
  EXPECT_NEAR(student_95(10), 2.228, 0.001);
  EXPECT_NEAR(student_95(30), 2.042, 0.001);
  EXPECT_NEAR(student_95(1e9), 1.960, 0.001);
}

}  // namespace
}  // namespace searig::estimator
