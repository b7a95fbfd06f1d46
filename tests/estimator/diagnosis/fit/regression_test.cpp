#include "estimator/diagnosis/fit/regression.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tests/estimator/diagnosis/fit/gaussian.h"

namespace searig::estimator {
namespace {

double residual_sse(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right) {
  const Eigen::VectorXd x =
      (columns.transpose() * columns).llt().solve(columns.transpose() * right);
  return (right - columns * x).squaredNorm();
}

TEST(Solve, AgreesWithTheNormalEquations) {
  Eigen::MatrixXd columns = gaussian(200, 5, 1);
  columns.col(2) *= 1e6;  // columns of very different size
  columns.col(4) *= 1e-6;
  const Eigen::VectorXd right = gaussian(200, 1, 2);
  const Solution s = solve(columns, right);
  Eigen::MatrixXd scaled = columns;
  const Eigen::VectorXd norm = columns.colwise().norm();
  scaled *= norm.cwiseInverse().asDiagonal();
  const Eigen::MatrixXd inverse = (scaled.transpose() * scaled).inverse();
  const Eigen::VectorXd expected = inverse * scaled.transpose() * right;
  for (int i = 0; i < 5; ++i) {
    EXPECT_NEAR(s.coefficients[i] * norm[i], expected[i], 1e-10);
    EXPECT_NEAR(s.sd[i] * norm[i], std::sqrt(inverse(i, i)), 1e-10);
  }
  EXPECT_NEAR(s.sse, (right - columns * s.coefficients).squaredNorm(), 1e-10);
  EXPECT_LT((columns.transpose() * s.residual).cwiseQuotient(norm).norm(), 1e-10);
}

TEST(Solve, FindsWhatWasPutIn) {
  const Eigen::MatrixXd columns = gaussian(50, 4, 3);
  const Eigen::Vector4d truth(1, -2, 0, 3e-3);
  EXPECT_LT((solve(columns, columns * truth).coefficients - truth).norm(), 1e-13);
}

TEST(Solve, GivesAColumnOfZerosTheCoefficientZero) {
  Eigen::MatrixXd columns = gaussian(50, 3, 4);
  columns.col(1).setZero();
  const Solution s = solve(columns, gaussian(50, 1, 5));
  EXPECT_EQ(s.coefficients[1], 0.0);
  EXPECT_TRUE(s.coefficients.allFinite());
}

TEST(Solve, SplitsWhatTwoEqualColumnsShareWithoutBreaking) {
  Eigen::MatrixXd columns = gaussian(50, 3, 6);
  columns.col(2) = columns.col(0);
  const Eigen::VectorXd right = columns.col(0) * 3 + columns.col(1);
  const Solution s = solve(columns, right);
  EXPECT_TRUE(s.coefficients.allFinite());
  EXPECT_NEAR(s.coefficients[0] + s.coefficients[2], 3.0, 1e-10);
}

TEST(Gain, IsTheFallOfTheSumOfSquares) {
  const Eigen::MatrixXd fixed = gaussian(300, 4, 7), candidate = gaussian(300, 2, 8);
  const Eigen::VectorXd right = candidate * Eigen::Vector2d(0.5, -1) + gaussian(300, 1, 9);
  Eigen::MatrixXd both(300, 6);
  both << fixed, candidate;
  const Projection projection(fixed, right);
  const auto gain = projection.gain(candidate);
  EXPECT_NEAR(projection.sse(), residual_sse(fixed, right), 1e-9);
  EXPECT_NEAR(gain.sse, residual_sse(fixed, right) - residual_sse(both, right), 1e-5);
  EXPECT_LT((gain.coefficients - solve(both, right).coefficients.tail(2)).norm(), 1e-7);
}

TEST(Gain, IsNothingForWhatTheFixedColumnsSpan) {
  const Eigen::MatrixXd fixed = gaussian(300, 4, 10);
  const Projection projection(fixed, gaussian(300, 1, 11));
  const auto spanned = projection.gain(fixed * Eigen::Vector4d(1, 2, 3, 4));
  EXPECT_EQ(spanned.sse, 0.0);
  EXPECT_LT(spanned.independence, 1e-5);
  EXPECT_EQ(projection.gain(Eigen::MatrixXd::Zero(300, 1)).sse, 0.0);
}

TEST(Gain, SaysHowMuchOfTheCandidateIsItsOwn) {
  Eigen::MatrixXd fixed(3, 1), candidate(3, 1);
  fixed << 1, 0, 0;
  candidate << 4, 3, 0;
  EXPECT_NEAR(Projection(fixed, Eigen::Vector3d(1, 1, 1)).gain(candidate).independence, 0.6, 1e-12);
}

TEST(HeldOut, IsPredictedByFitsThatDidNotSeeTheBlock) {
  const Eigen::MatrixXd columns = gaussian(120, 3, 12);
  const Eigen::VectorXd right =
      columns * Eigen::Vector3d(1, 2, 3) + 0.5 * gaussian(120, 1, 13).col(0);
  std::vector<int> block(120);
  for (int i = 0; i < 120; ++i) block[std::size_t(i)] = i < 10 ? -1 : (i / 5) % 4;  // not in a row
  std::vector<double> each;
  const double total = heldout_sse(columns, right, block, &each);
  ASSERT_EQ(each.size(), 4u);
  double sum = 0.0;
  for (int held = 0; held < 4; ++held) {
    Eigen::MatrixXd seen = columns;
    Eigen::VectorXd seen_right = right;
    for (int i = 0; i < 120; ++i)
      if (block[std::size_t(i)] == held) seen.row(i).setZero(), seen_right[i] = 0.0;
    const Eigen::VectorXd error = right - columns * solve(seen, seen_right).coefficients;
    double sse = 0.0;
    for (int i = 0; i < 120; ++i)
      if (block[std::size_t(i)] == held) sse += error[i] * error[i];
    EXPECT_NEAR(each[std::size_t(held)], sse, 1e-6);
    sum += sse;
  }
  EXPECT_NEAR(total, sum, 1e-6);
}

}  // namespace
}  // namespace searig::estimator
