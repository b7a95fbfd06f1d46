// Worked numbers of the spherical simplex, and the moments that it must have.
#include "estimator/filter/sigma_points.h"

#include <gtest/gtest.h>

#include <cmath>

namespace searig::estimator {
namespace {

template <int n>
Eigen::Vector<double, n> mean_of(const SphericalSimplex<n>& set) {
  return set.points() * set.mean_weights();
}

template <int n>
Eigen::Matrix<double, n, n> covariance_of(const SphericalSimplex<n>& set) {
  return set.points() * set.covariance_weights().asDiagonal() * set.points().transpose();
}

template <int n>
void expect_standard_moments(SimplexOptions options, double tolerance) {
  const SphericalSimplex<n> set(options);
  EXPECT_LT(mean_of(set).norm(), tolerance);
  EXPECT_LT((covariance_of(set) - Eigen::Matrix<double, n, n>::Identity()).norm(), tolerance);
  EXPECT_NEAR(set.mean_weights().sum(), 1, tolerance);
  const double radius2 = options.alpha * options.alpha * n / (1 - options.w0);
  for (int i = 1; i < set.count; ++i) {
    EXPECT_NEAR(set.points().col(i).squaredNorm(), radius2, tolerance);
  }
}

TEST(SphericalSimplex, HasMeanZeroAndCovarianceOne) {
  for (const double w0 : {0.0, 0.25, 0.5, 2.0 / 3.0}) {
    for (const double alpha : {1.0, 0.5, 0.1}) {
      const SimplexOptions options{w0, alpha, 2.0};
      expect_standard_moments<1>(options, 1e-12);
      expect_standard_moments<2>(options, 1e-12);
      expect_standard_moments<3>(options, 1e-12);
      expect_standard_moments<5>(options, 1e-12);
    }
  }
}

TEST(SphericalSimplex, OneState) {
  const SphericalSimplex<1> half({0.5, 1, 0});
  EXPECT_TRUE(half.mean_weights().isApprox(Eigen::Vector3d(0.5, 0.25, 0.25), 1e-15));
  const double root2 = 1.414213562373095;
  EXPECT_TRUE(half.points().transpose().isApprox(Eigen::Vector3d(0, -root2, root2), 1e-15));

  const SphericalSimplex<1> none({0.0, 1, 0});
  EXPECT_TRUE(none.points().transpose().isApprox(Eigen::Vector3d(0, -1, 1), 1e-15));

  const SphericalSimplex<1> two_thirds({2.0 / 3.0, 1, 0});
  const double root3 = 1.7320508075688772;
  EXPECT_TRUE(two_thirds.points().transpose().isApprox(Eigen::Vector3d(0, -root3, root3), 1e-15));
}

TEST(SphericalSimplex, TwoStates) {
  Eigen::Matrix<double, 2, 4> expected;
  expected << 0, -1.7320508075688774, 1.7320508075688774, 0,  //
      0, -1, -1, 2;
  EXPECT_TRUE(SphericalSimplex<2>({0.5, 1, 0}).points().isApprox(expected, 1e-15));

  expected << 0, -1.414213562373095, 1.414213562373095, 0,  //
      0, -0.8164965809277261, -0.8164965809277261, 1.6329931618554523;
  const SphericalSimplex<2> quarter({0.25, 1, 0});
  EXPECT_TRUE(quarter.points().isApprox(expected, 1e-15));
  EXPECT_TRUE(quarter.mean_weights().isApproxToConstant(0.25, 1e-15));

  expected << 0, -1.224744871391589, 1.224744871391589, 0,  //
      0, -0.7071067811865475, -0.7071067811865475, 1.414213562373095;
  EXPECT_TRUE(SphericalSimplex<2>({0.0, 1, 0}).points().isApprox(expected, 1e-15));
}

TEST(SphericalSimplex, ThreeStates) {
  const double a = 1.1547005383792517, b = 0.8164965809277261;
  Eigen::Matrix<double, 3, 5> expected;
  expected << 0, -2, 2, 0, 0,            //
      0, -a, -a, 2.3094010767585034, 0,  //
      0, -b, -b, -b, 2.4494897427831783;
  const SphericalSimplex<3> set({0.5, 1, 0});
  EXPECT_TRUE(set.points().isApprox(expected, 1e-15));
  EXPECT_TRUE(set.mean_weights().tail<4>().isApproxToConstant(0.125, 1e-15));
}

TEST(SphericalSimplex, ScaledWeights) {
  const SphericalSimplex<1> one({0.5, 0.5, 2});
  EXPECT_TRUE(one.mean_weights().isApprox(Eigen::Vector3d(-1, 1, 1), 1e-15));
  EXPECT_TRUE(one.covariance_weights().isApprox(Eigen::Vector3d(1.75, 1, 1), 1e-15));
  EXPECT_NEAR(one.points()(2), 0.7071067811865475, 1e-15);

  const SphericalSimplex<2> two({0.5, 0.5, 2});
  const double third2 = 2.0 / 3.0;
  EXPECT_TRUE(two.mean_weights().isApprox(Eigen::Vector4d(-1, third2, third2, third2), 1e-15));
  EXPECT_TRUE(two.covariance_weights().isApprox(Eigen::Vector4d(1.75, third2, third2, third2)));
  Eigen::Matrix<double, 2, 4> expected;
  expected << 0, -0.8660254037844387, 0.8660254037844387, 0, 0, -0.5, -0.5, 1;
  EXPECT_TRUE(two.points().isApprox(expected, 1e-15));
}

// A simplex is not symmetric: these third moments are what biases a squared measurement.
TEST(SphericalSimplex, ThirdMomentsOfTwoStatesAreNotZero) {
  const SphericalSimplex<2> set({0.5, 1, 0});
  const auto z1 = set.points().row(0).array(), z2 = set.points().row(1).array();
  const auto w = set.mean_weights().transpose().array();
  EXPECT_NEAR((w * z1 * z1 * z2).sum(), -1, 1e-14);
  EXPECT_NEAR((w * z2 * z2 * z2).sum(), 1, 1e-14);
}

TEST(SphericalSimplex, RefusesWeightsThatAreNone) {
  EXPECT_THROW(SphericalSimplex<2>({1.0, 1, 0}), std::invalid_argument);
  EXPECT_THROW(SphericalSimplex<2>({-0.1, 1, 0}), std::invalid_argument);
  EXPECT_THROW(SphericalSimplex<2>({0.5, 0, 0}), std::invalid_argument);
  EXPECT_THROW(SphericalSimplex<2>({std::nan(""), 1, 0}), std::invalid_argument);
}

}  // namespace
}  // namespace searig::estimator
