#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "../hand_made_motion.h"

namespace searig::estimator {
namespace {

Term one_branch(double k1, double tau) {
  return {"spring.relaxation", {{"k1_nm_per_rad", k1}, {"tau_s", tau}}};
}

/// dx/dt = (theta - x)/tau with theta straight between samples, by Runge-Kutta in small steps.
std::vector<double> integrated(const Motion& m, double tau) {
  std::vector<double> lag{0.0};
  double x = m.theta[0];
  for (std::size_t i = 1; i < m.size(); ++i) {
    constexpr int steps = 20;
    const double h = (m.t[i] - m.t[i - 1]) / steps;
    const double slope = (m.theta[i] - m.theta[i - 1]) / (m.t[i] - m.t[i - 1]);
    for (int s = 0; s < steps; ++s) {
      const double theta = m.theta[i - 1] + slope * s * h;
      const auto rate = [&](double dt, double y) { return (theta + slope * dt - y) / tau; };
      const double r1 = rate(0, x), r2 = rate(h / 2, x + h / 2 * r1);
      const double r3 = rate(h / 2, x + h / 2 * r2), r4 = rate(h, x + h * r3);
      x += h / 6 * (r1 + 2 * r2 + 2 * r3 + r4);
    }
    lag.push_back(m.theta[i] - x);
  }
  return lag;
}

TEST(Relaxation, FollowsItsEquation) {
  const Motion motion = hand_made_motion();
  for (const double tau : {0.1, 0.7, 5.0}) {
    const Eigen::VectorXd torque = torque_of(one_branch(15, tau), motion);
    const auto lag = integrated(motion, tau);
    for (std::size_t i = 0; i < motion.size(); ++i)
      ASSERT_NEAR(torque[Eigen::Index(i)], 15 * lag[i], 1e-8) << "tau " << tau << " at " << i;
  }
}

TEST(Relaxation, DecaysByEWithinItsTimeConstantAfterARamp) {
  std::vector<double> theta = path_through({0, 0.1}, 10);
  const auto held = path_through({0.1, 0.1}, 300);
  theta.insert(theta.end(), held.begin() + 1, held.end());
  const Motion motion = deflected(theta, 0.01);
  const Eigen::VectorXd torque = torque_of(one_branch(15, 1.0), motion);
  // A ramp of r rad/s for t seconds leaves r*tau*(1 - exp(-t/tau)).
  EXPECT_NEAR(torque[10], 15 * 1.0 * (1 - std::exp(-0.1)), 1e-12);
  EXPECT_NEAR(torque[110], torque[10] * std::exp(-1.0), 1e-12);
}

TEST(Relaxation, HasSeveralBranchesThatAdd) {
  const Motion motion = hand_made_motion();
  Term both = one_branch(15, 0.3);
  both.parameters["k2_nm_per_rad"] = 4;
  both.parameters["tau2_s"] = 3;
  const Eigen::VectorXd sum =
      torque_of(one_branch(15, 0.3), motion) + torque_of(one_branch(4, 3), motion);
  EXPECT_LT((torque_of(both, motion) - sum).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Relaxation, IsADamperWhenFastAndASpringWhenSlow) {
  const Motion motion = hand_made_motion();
  const Eigen::VectorXd fast = torque_of(one_branch(100, 0.001), motion);
  const Eigen::VectorXd slow = torque_of(one_branch(10, 1e5), motion);
  for (std::size_t i = 100; i < motion.size(); ++i) {
    EXPECT_NEAR(fast[Eigen::Index(i)], 0.1 * motion.theta_rate[i], 2e-3);
    EXPECT_NEAR(slow[Eigen::Index(i)], 10 * (motion.theta[i] - motion.theta[0]), 1e-3);
  }
}

}  // namespace
}  // namespace searig::estimator
