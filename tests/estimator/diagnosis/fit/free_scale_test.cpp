#include "estimator/diagnosis/fit/free_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/estimator/diagnosis/fit/gaussian.h"

namespace searig::estimator {
namespace {

/// A spring of k = 40 on a load cell whose noise hides nearly everything, and a motor of g = 2.5
/// whose noisy current must carry the same torque. Columns: g, k; drive rows first.
struct NoisyMotor {
  static constexpr Eigen::Index rows = 4000;
  static constexpr double k = 40.0, g = 2.5;
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(2 * rows, 2);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * rows);

  explicit NoisyMotor(unsigned seed) {
    const Eigen::VectorXd theta = gaussian(rows, 1, seed), noise = gaussian(2 * rows, 1, seed + 1);
    const double current_sd = 0.5, loadcell_sd = 40.0;
    const Eigen::VectorXd current = k / g * theta + current_sd * noise.head(rows);
    columns.col(0).head(rows) = current / (g * current_sd);
    columns.col(1).head(rows) = -theta / (g * current_sd);
    columns.col(1).tail(rows) = theta / loadcell_sd;
    right.tail(rows) = k * theta / loadcell_sd + noise.tail(rows);
  }
};

TEST(SolveFreeScale, DoesNotShrinkWhereLeastSquaresDoes) {
  for (unsigned seed : {20u, 30u, 40u}) {
    NoisyMotor rig(seed);
    const Solution plain = solve(rig.columns, rig.right);
    EXPECT_LT(plain.coefficients[1], 0.6 * NoisyMotor::k);
    const Solution s = solve(rig.columns, rig.right, {0, 0, NoisyMotor::rows, NoisyMotor::g});
    const double sd = 40.0 / std::sqrt(double(NoisyMotor::rows));  // of k, from the load cell
    EXPECT_NEAR(s.coefficients[1], NoisyMotor::k, 3.0 * sd);
    EXPECT_NEAR(s.coefficients[1] / s.coefficients[0], NoisyMotor::k / NoisyMotor::g, 0.05);
  }
}

TEST(SolveFreeScale, LeavesAProblemThatLeastSquaresSolvesAlike) {
  NoisyMotor rig(50);
  const Solution s = solve(rig.columns, rig.right, {0, 0, NoisyMotor::rows, 3.0});
  const Solution again = solve(rig.columns, rig.right);
  EXPECT_LT((s.coefficients - again.coefficients).norm(), 1e-5);
  EXPECT_LT((s.residual - again.residual).norm(), 1e-4);
}

TEST(SolveFreeScale, MinimisesWhatItSays) {
  NoisyMotor rig(60);
  const Eigen::MatrixXd columns = rig.columns;
  const Eigen::VectorXd right = rig.right;
  const double reference = 2.0;
  const auto cost = [&](const Eigen::Vector2d& x) {
    const Eigen::VectorXd r = right - columns * x;
    return r.tail(NoisyMotor::rows).squaredNorm() +
           std::pow(reference / x[0], 2) * r.head(NoisyMotor::rows).squaredNorm();
  };
  const Solution s = solve(rig.columns, rig.right, {0, 0, NoisyMotor::rows, reference});
  EXPECT_NEAR(s.sse, cost(s.coefficients), 1e-6 * s.sse);
  for (const double step : {-1e-3, 1e-3})
    for (const Eigen::Vector2d& way : {Eigen::Vector2d(2.5, 40), Eigen::Vector2d(2.5, -40)})
      EXPECT_GT(cost(s.coefficients + step * way), s.sse);
}

}  // namespace
}  // namespace searig::estimator
