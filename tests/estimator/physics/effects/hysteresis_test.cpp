#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../hand_made_motion.h"

namespace searig::estimator {
namespace {

constexpr double torque = 2.0, yield = 0.05;
const Term term{"spring.hysteresis", {{"torque_nm", torque}, {"yield_rad", yield}}};

TEST(Hysteresis, FollowsBoucAndWensEquation) {
  const Motion motion = hand_made_motion();
  const Eigen::VectorXd got = torque_of(term, motion);
  double z = 0.0;
  for (std::size_t i = 1; i < motion.size(); ++i) {
    constexpr int steps = 400;
    const double step = (motion.theta[i] - motion.theta[i - 1]) / steps;
    const auto rate = [&](double y) { return (1 - (y * step > 0 ? y * y : 0)) * step / yield; };
    for (int s = 0; s < steps; ++s) z += rate(z + 0.5 * rate(z));
    ASSERT_NEAR(got[Eigen::Index(i)], torque * z, 2e-5) << "at " << i;
  }
}

TEST(Hysteresis, DoesNotCareHowFastThePathIsGoneNorHowFinelyItIsSampled) {
  const std::vector<double> corners{0, 0.2, -0.1, 0.15, -0.2, 0.03};
  const Eigen::VectorXd fast = torque_of(term, deflected(path_through(corners, 40), 0.001));
  const Eigen::VectorXd slow = torque_of(term, deflected(path_through(corners, 40), 0.1));
  const Eigen::VectorXd coarse = torque_of(term, deflected(path_through(corners, 1), 1.0));
  EXPECT_EQ(fast, slow);
  for (Eigen::Index c = 0; c < coarse.size(); ++c) EXPECT_NEAR(coarse[c], fast[40 * c], 1e-12);
}

TEST(Hysteresis, SaturatesAtItsTorqueAndStartsBackWithTheSlopeOfTheYield) {
  const Motion motion = deflected(path_through({0, 0.5, -0.5}, 5000), 0.001);
  const Eigen::VectorXd got = torque_of(term, motion);
  EXPECT_NEAR(got[5000], torque, 1e-6);
  EXPECT_LE(got.cwiseAbs().maxCoeff(), torque);
  EXPECT_NEAR(got[5010], torque - torque / yield * 10 * 1e-4 * 2, 1e-5);
  EXPECT_NEAR(got[10000], -torque, 1e-6);
  const auto at = Eigen::Index(5000 + (3 * yield) / 2e-4);  // three yields after the reversal
  EXPECT_LT(got[at], -0.9 * torque);
}

TEST(Hysteresis, ReturnsToTheSamePointsRoundAfterRoundAndTakesTheLoopsEnergy) {
  const double a = 0.3;
  const int n = 20000;
  const auto path = path_through({0, a, -a, a, -a, a}, n);
  const Eigen::VectorXd got = torque_of(term, deflected(path, 0.001));
  for (int i = 0; i < 2 * n; i += 97) ASSERT_NEAR(got[n + i], got[3 * n + i], 1e-4);
  double energy = 0.0;
  for (int i = 3 * n; i < 5 * n; ++i)
    energy += 0.5 * (got[i] + got[i + 1]) * (path[std::size_t(i) + 1] - path[std::size_t(i)]);
  // Half a loop: straight over one yield, then a tanh to the other end.
  const double half = -yield / 2 + yield * std::log(std::cosh((2 * a - yield) / yield));
  EXPECT_NEAR(energy, 2 * torque * half, 1e-5);
}

TEST(Hysteresis, IsTheSameToBothSides) {
  const auto path = path_through({0, 0.2, -0.1, 0.15}, 50);
  std::vector<double> mirrored = path;
  for (double& x : mirrored) x = -x;
  const Eigen::VectorXd one = torque_of(term, deflected(path, 0.01));
  EXPECT_LT((one + torque_of(term, deflected(mirrored, 0.01))).cwiseAbs().maxCoeff(), 1e-14);
}

}  // namespace
}  // namespace searig::estimator
