#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made_motion.h"

namespace searig::estimator {
namespace {

constexpr double k = 40;  // of hand_made_model()

Term softening(double share, double scale, double history) {
  return {"spring.mullins", {{"share", share}, {"scale", scale}, {"history", history}}};
}

Motion loaded(const std::vector<double>& theta) {
  Motion m = deflected(theta, 0.001);
  for (std::size_t i = 0; i < theta.size(); ++i) m.spring_nm[i] = k * theta[i];
  return m;
}

/// Lost stiffness over k, where there is a deflection to see it by.
double loss(const Eigen::VectorXd& torque, const Motion& m, int i) {
  return -torque[i] / (k * m.theta[std::size_t(i)]);
}

TEST(Mullins, LosesStiffnessByTheWorkDone) {
  const Motion m = loaded(path_through({0, 0.3}, 20000));
  const Eigen::VectorXd torque = torque_of(softening(0.2, 1.5, 0), m);
  for (const int i : {5000, 10000, 20000}) {
    const double work = 0.5 * k * std::pow(m.theta[std::size_t(i)], 2);
    EXPECT_NEAR(loss(torque, m, i), 0.2 * (1 - std::exp(-work / 1.5)), 1e-4);
  }
}

TEST(Mullins, TakesTheWorkDoneUnlessToldOtherwise) {
  const Motion m = hand_made_motion();
  const Term plain{"spring.mullins", {{"share", 0.2}, {"scale", 1.5}}};
  EXPECT_EQ(torque_of(plain, m), torque_of(softening(0.2, 1.5, 0), m));
  EXPECT_NE(torque_of(plain, m), torque_of(softening(0.2, 1.5, 1), m));
}

TEST(Mullins, LosesStiffnessByTheLargestDeflectionToEitherSide) {
  const Motion m = loaded(path_through({0, 0.1, -0.3, 0.2, -0.2}, 1000));
  const Eigen::VectorXd torque = torque_of(softening(0.2, 0.15, 1), m);
  const double at_peak = 0.2 * (1 - std::exp(-0.3 / 0.15));
  EXPECT_NEAR(loss(torque, m, 1000), 0.2 * (1 - std::exp(-0.1 / 0.15)), 1e-12);
  EXPECT_NEAR(loss(torque, m, 2000), at_peak, 1e-12);
  EXPECT_NEAR(loss(torque, m, 3000), at_peak, 1e-12);  // smaller cycles change nothing
  EXPECT_NEAR(loss(torque, m, 4000), at_peak, 1e-12);
}

TEST(Mullins, IsFeltBelowTheLargestLoadAndGoneOnTheWayBeyondIt) {
  const Motion m = loaded(path_through({0, 0.2, 0.1, 0.3, 0}, 1000));
  const Eigen::VectorXd torque = torque_of(softening(0.2, 0.5, 2), m);
  const auto stored = [](double theta) { return 0.5 * k * theta * theta; };
  EXPECT_NEAR(loss(torque, m, 500), 0.0, 1e-12);  // never loaded before
  EXPECT_NEAR(loss(torque, m, 2000), 0.2 * (1 - std::exp(-(stored(0.2) - stored(0.1)) / 0.5)),
              1e-12);
  EXPECT_NEAR(loss(torque, m, 2500), 0.0, 1e-12);  // at 0.2 again, and then beyond
  EXPECT_NEAR(loss(torque, m, 3000), 0.0, 1e-12);
}

TEST(Mullins, OnlySoftensAndNeverBeyondItsShare) {
  const Motion m = hand_made_motion();
  for (const double history : {0.0, 1.0}) {
    const Eigen::VectorXd torque = torque_of(softening(0.2, 0.1, history), m);
    double last = 0.0;
    for (int i = 1; i < int(m.size()); ++i) {
      if (std::abs(m.theta[std::size_t(i)]) < 1e-6) continue;
      const double now = loss(torque, m, i);
      ASSERT_GE(now, last - 1e-12);
      ASSERT_LE(now, 0.2);
      last = now;
    }
    EXPECT_GT(last, 0.1);
  }
}

TEST(Mullins, DoesNotSoftenWhileHeldOrUnloaded) {
  const Motion m = loaded(path_through({0, 0.2, 0.2, 0.05}, 1000));
  const Eigen::VectorXd torque = torque_of(softening(0.2, 0.5, 0), m);
  EXPECT_NEAR(loss(torque, m, 1000), loss(torque, m, 2000), 1e-12);
  EXPECT_NEAR(loss(torque, m, 2000), loss(torque, m, 3000), 1e-12);
}

}  // namespace
}  // namespace searig::estimator
