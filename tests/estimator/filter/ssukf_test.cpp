// The filter held against what is known exactly: Kalman's filter on linear models, the closed
// form of Gaussian moments on the paper's squared error, and worked numbers.
#include "estimator/filter/ssukf.h"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <random>

#include "estimator/filter/exact_moments.h"

namespace searig::estimator {
namespace {

template <int n>
using Vec = Eigen::Vector<double, n>;
template <int n>
using Mat = Eigen::Matrix<double, n, n>;

struct Gap {
  double state = 0;       // largest |x - x_exact|
  double covariance = 0;  // largest relative |P - P_exact|
};

// A damped linear system with a process noise as large as its state, observed through one number
// with little noise: what a filter that forgets Q somewhere cannot follow.
template <int n>
Gap distance_from_kalman(SimplexOptions simplex, int steps) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto noise = [&] { return normal(random); };
  const Mat<n> A = 0.9 * Mat<n>::Identity() + 0.1 * Mat<n>::NullaryExpr(noise);
  const Vec<n> c = Vec<n>::Ones() + 0.5 * Vec<n>::NullaryExpr(noise);
  Mat<n> Q = 0.2 * Mat<n>::Identity();
  Q(0, 0) = 0.5;
  const double R = 0.3;

  Vec<n> x = Vec<n>::Ones();
  Mat<n> P = 2 * Mat<n>::Identity();
  Ssukf<n> filter(x, P, SphericalSimplex<n>(simplex));
  Gap gap;
  for (int step = 0; step < steps; ++step) {
    const double z = 3 * noise();
    EXPECT_TRUE(filter.predict([&](const Vec<n>& s) { return Vec<n>(A * s); }, Q));
    EXPECT_TRUE(filter.update([&](const Vec<n>& s) { return c.dot(s); }, z, R));

    x = A * x;
    P = A * P * A.transpose() + Q;
    const Vec<n> K = P * c / (c.dot(P * c) + R);
    x += K * (z - c.dot(x));
    P -= K * c.transpose() * P;
    gap.state = std::max(gap.state, (filter.state() - x).norm());
    gap.covariance = std::max(gap.covariance, (filter.covariance() - P).norm() / P.norm());
  }
  return gap;
}

template <int n>
void expect_kalman(SimplexOptions simplex, double tolerance) {
  const Gap gap = distance_from_kalman<n>(simplex, 400);
  EXPECT_LT(gap.state, tolerance) << "n = " << n;
  EXPECT_LT(gap.covariance, tolerance) << "n = " << n;
}

TEST(Ssukf, IsTheKalmanFilterOnALinearModelWithLargeQ) {
  for (const double w0 : {0.0, 0.5, 2.0 / 3.0}) {
    expect_kalman<1>({w0, 1, 0}, 1e-12);
    expect_kalman<2>({w0, 1, 0}, 1e-12);
    expect_kalman<3>({w0, 1, 0}, 1e-12);
    expect_kalman<4>({w0, 1, 0}, 1e-12);
  }
}

TEST(Ssukf, IsTheKalmanFilterToWhatCancellationLeavesWhereThePointsAreClose) {
  expect_kalman<2>({0, 1e-3, 2}, 1e-7);
  expect_kalman<3>({0, 1e-3, 2}, 1e-7);
}

// Two measurements at once, and a state that stands still: predict(Q) is predict(identity, Q).
TEST(Ssukf, IsTheKalmanFilterForSeveralMeasurements) {
  const Mat<2> Q = Vec<2>(0.5, 0.2).asDiagonal();
  const Mat<2> R = Vec<2>(0.3, 0.1).asDiagonal();
  Mat<2> C;
  C << 1, 0.5, -0.3, 2;
  Vec<2> x(1, -1);
  Mat<2> P = Mat<2>::Identity();
  Ssukf<2> filter(x, P, SphericalSimplex<2>({0.5, 1, 0}));
  for (int step = 0; step < 100; ++step) {
    const Vec<2> z(std::sin(step), std::cos(step));
    ASSERT_TRUE(filter.predict(Q));
    ASSERT_TRUE(filter.update([&](const Vec<2>& s) { return Vec<2>(C * s); }, z, R));
    P += Q;
    const Mat<2> K = P * C.transpose() * (C * P * C.transpose() + R).inverse();
    x += K * (z - C * x);
    P -= K * C * P;
    ASSERT_LT((filter.state() - x).norm(), 1e-12);
    ASSERT_LT((filter.covariance() - P).norm(), 1e-12);
  }
}

// Notes on code bases, B4: one step of the paper's filter for k.
struct OneStep {
  Ssukf<1> filter;
  explicit OneStep(double w0) : filter(Vec<1>(50), Mat<1>(100), SphericalSimplex<1>({w0, 1, 0})) {
    const auto error = [](const Vec<1>& k) { return std::pow(8 - 0.1 * k(0), 2); };
    EXPECT_TRUE(filter.predict(Mat<1>(1e-4 * 50)));
    EXPECT_TRUE(filter.update(error, 0.0, 1.0));
  }
};

TEST(Ssukf, OneStepOfThePaper) {
  const OneStep half(0.5);
  EXPECT_NEAR(half.filter.state()(0), 65.78955263054021, 1e-11);
  EXPECT_NEAR(half.filter.covariance()(0), 5.263421058864239, 1e-11);
  const OneStep two_thirds(2.0 / 3.0);
  EXPECT_NEAR(two_thirds.filter.state()(0), 65.38467258276695, 1e-11);
  EXPECT_NEAR(two_thirds.filter.covariance()(0), 7.6928106625701815, 1e-11);
}

// B4: the draw for n = 2 through h = x0^2 + x1, seen from outside through the update it makes.
TEST(Ssukf, OneStepOfTwoStates) {
  const Vec<2> x(1, 2);
  Mat<2> P;
  P << 4, 1, 1, 2;
  Ssukf<2> filter(x, P, SphericalSimplex<2>({0.5, 1, 0}));
  const auto h = [](const Vec<2>& s) { return s(0) * s(0) + s(1); };
  const double z = 10, R = 0.7;
  ASSERT_TRUE(filter.update(h, z, R));

  const double y = 7, Pyy = 43.41699475574167 + R;
  const Vec<2> Pxy(9, -1.2915026221291819);  // exact: (9, +4)
  const Vec<2> expected_x = x + Pxy / Pyy * (z - y);
  const Mat<2> expected_P = P - Pxy * Pxy.transpose() / Pyy;
  EXPECT_LT((filter.state() - expected_x).norm(), 1e-12);
  EXPECT_LT((filter.covariance() - expected_P).norm(), 1e-12);
}

TEST(Ssukf, EqualsTheClosedFormOfASquaredErrorForOneState) {
  const SimplexOptions exact[] = {{2.0 / 3.0, 1, 0}, {0, 0.1, 2}, {0, 0.5, 2}, {0.5, 0.5, 2}};
  // For w0 = 1/2 the closed form has beta = 2 - alpha^2 W0/(1 - W0) = 1.75.
  for (SimplexOptions simplex : exact) {
    if (simplex.alpha < 1) {
      simplex.beta = 2 - simplex.alpha * simplex.alpha * simplex.w0 / (1 - simplex.w0);
    }
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    Ssukf<1> filter(Vec<1>(50), Mat<1>(100), SphericalSimplex<1>(simplex));
    ExactMomentFilter<1> closed{Vec<1>(50), Mat<1>(100)};
    for (int step = 0; step < 2000; ++step) {
      const double theta = 0.15 * std::sin(0.01 * step), w = 0.5 + 0.5 * std::cos(0.03 * step);
      const double T = 80 * theta + 0.05 * normal(random);
      const Mat<1> Q(1e-4 * filter.state()(0));
      ASSERT_TRUE(filter.predict(Q));
      ASSERT_TRUE(filter.update([&](const Vec<1>& k) { return w * std::pow(T - theta * k(0), 2); },
                                0.0, 1.0));
      closed.step(Vec<1>(theta), T, w, Q, 1.0);
      ASSERT_NEAR(filter.state()(0), closed.x(0), 1e-10 * closed.x(0));
      ASSERT_NEAR(filter.covariance()(0), closed.P(0), 1e-10 * closed.P(0));
    }
  }
}

// The stream of the notes, B1: a spring with a cubic and a viscous term, 16 passes of 4096 samples.
template <int n>
struct Stream {
  static constexpr double truth[] = {80, 20, 5};
  static constexpr double start[] = {50, 10, 1};
  static constexpr int steps = 16384;

  // Runs step(phi, T, Q) over the stream, which begins again every 4096 samples.
  template <class Step>
  static void run(Step&& step) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    for (int i = 0; i < steps; ++i) {
      const double A = 0.15, phase = 2 * M_PI * 0.5 * (i % 4096) / 1000.0;
      const double theta = A * std::sin(phase);
      const double terms[] = {theta, std::pow(theta, 3) / (A * A), A * std::cos(phase)};
      const Vec<n> phi(terms);
      const double T = phi.dot(Vec<n>(truth)) + 0.05 * normal(random);
      step(phi, T);
    }
  }

  static Vec<n> sigma_points(SimplexOptions simplex) {
    Ssukf<n> filter(Vec<n>(start), 100 * Mat<n>::Identity(), SphericalSimplex<n>(simplex));
    run([&](const Vec<n>& phi, double T) {
      const Mat<n> Q = 1e-4 * filter.state().cwiseAbs().asDiagonal().toDenseMatrix();
      EXPECT_TRUE(filter.predict(Q));
      EXPECT_TRUE(
          filter.update([&](const Vec<n>& x) { return std::pow(T - phi.dot(x), 2); }, 0.0, 1.0));
    });
    return filter.state();
  }

  static Vec<n> exact() {
    ExactMomentFilter<n> filter{Vec<n>(start), 100 * Mat<n>::Identity()};
    run([&](const Vec<n>& phi, double T) {
      filter.step(phi, T, 1, 1e-4 * filter.x.cwiseAbs().asDiagonal().toDenseMatrix(), 1);
    });
    return filter.x;
  }
};

template <int n>
double distance_from_truth(const Vec<n>& x) {
  return (x - Vec<n>(Stream<n>::truth)).template lpNorm<Eigen::Infinity>();
}

TEST(Ssukf, UnscaledSimplexIsBiasedBySquaresAndOursIsNot) {
  EXPECT_GT(distance_from_truth<2>(Stream<2>::sigma_points({0.5, 1, 0})), 2);
  EXPECT_GT(distance_from_truth<3>(Stream<3>::sigma_points({0.5, 1, 0})), 5);

  const Vec<2> two = Stream<2>::sigma_points(unbiased_for_squares<2>());
  EXPECT_LT((two - Stream<2>::exact()).norm(), 0.15);
  EXPECT_LT(distance_from_truth<2>(two), 0.5);
  const Vec<3> three = Stream<3>::sigma_points(unbiased_for_squares<3>());
  EXPECT_LT((three - Stream<3>::exact()).norm(), 0.15);
  EXPECT_LT(distance_from_truth<3>(three), 0.5);
}

TEST(Ssukf, NeverAllocatesAfterConstruction) {
  Ssukf<3> filter(Vec<3>(1, 2, 3), Mat<3>::Identity());
  const Mat<3> Q = 0.1 * Mat<3>::Identity();
  Eigen::internal::set_is_malloc_allowed(false);
  bool ok = true;
  for (int step = 0; step < 10; ++step) {
    ok &= filter.predict(Q);
    ok &= filter.predict([](const Vec<3>& x) { return Vec<3>(0.9 * x); }, Q);
    ok &= filter.update([](const Vec<3>& x) { return x.squaredNorm(); }, 0.0, 1.0);
    ok &= filter.update([](const Vec<3>& x) { return Vec<2>(x.head<2>()); }, Vec<2>(1, 2),
                        Mat<2>(Mat<2>::Identity()));
  }
  Eigen::internal::set_is_malloc_allowed(true);
  EXPECT_TRUE(ok);
}

TEST(Ssukf, TheTestAgainstAllocationCanFail) {
  Eigen::internal::set_is_malloc_allowed(false);
  EXPECT_THROW(Eigen::VectorXd(Eigen::VectorXd::Zero(10)), std::logic_error);
  Eigen::internal::set_is_malloc_allowed(true);
}

TEST(Ssukf, IsLeftAloneByWhatIsNotANumber) {
  Ssukf<1> filter(Vec<1>(50), Mat<1>(100));
  EXPECT_FALSE(filter.predict(Mat<1>(NAN)));
  EXPECT_FALSE(filter.predict(Mat<1>(-200)));
  EXPECT_FALSE(filter.update([](const Vec<1>&) { return std::nan(""); }, 0.0, 1.0));
  EXPECT_FALSE(filter.update([](const Vec<1>& x) { return x(0); }, INFINITY, 1.0));
  EXPECT_EQ(filter.state()(0), 50);
  EXPECT_EQ(filter.covariance()(0), 100);
  EXPECT_THROW(Ssukf<1>(Vec<1>(50), Mat<1>(0)), std::invalid_argument);
}

}  // namespace
}  // namespace searig::estimator
