#include "estimator/diagnosis/rows/experiment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "tests/estimator/diagnosis/simulated_actuator.h"

namespace searig::estimator {
namespace {

Signals quiet() {
  SimulatedActuator rig;
  rig.noise_nm = rig.noise_a = 0;
  return rig.record();
}

TEST(Experiment, ComparesTheLoadcellAtItsOwnSamplesAndTheDriveFiftyTimesPerSecond) {
  const Signals s = quiet();
  const Experiment e = prepare(s, 0.01);
  ASSERT_TRUE(e.has_spring() && e.has_drive());
  EXPECT_EQ(e.loadcell_rows(), Eigen::Index(s.loadcell.t_s.size()));
  EXPECT_NEAR(double(e.drive_rows()), 50 * 36, 20);
  EXPECT_EQ(e.rows(), e.loadcell_rows() + e.drive_rows());
  for (Eigen::Index i = 0; i < e.loadcell_rows(); ++i)
    ASSERT_EQ(e.measured[i], s.loadcell.torque_nm[std::size_t(i)]);
  EXPECT_EQ(e.measured.tail(e.drive_rows()).norm(), 0.0);
  EXPECT_EQ(e.time(e.loadcell_rows()), e.drive_t.front());
}

TEST(Experiment, SeesTheTorqueWhereAngleAndLoadcellMeet) {
  const SimulatedActuator rig;
  const Experiment e = prepare(quiet(), 0.01);
  Eigen::VectorXd theta(Eigen::Index(e.motion.size()));
  std::ranges::copy(e.motion.theta, theta.begin());
  const Eigen::VectorXd seen = rig.k * e.at_loadcell(theta);
  for (Eigen::Index i = 0; i < e.loadcell_rows(); ++i)
    ASSERT_TRUE(!e.usable[std::size_t(i)] || std::abs(seen[i] - e.measured[i]) < 0.01) << i;
}

TEST(Experiment, HoldsCurrentAndAnglesThroughOneFilterAgainstEachOther) {
  const SimulatedActuator rig;
  Signals s = quiet();
  for (std::size_t i = 0; i < s.module.t_s.size(); ++i) {  // faster than the filter lets through
    const double fast = 2 * M_PI * 14 * s.module.t_s[i];
    s.module.deflection_rad[i] += 0.002 * std::sin(fast);
    s.module.input_angle_rad[i] += 0.002 * std::sin(fast);
    s.module.current_a[i] += rig.k * 0.002 * std::sin(fast) / rig.gain;
  }
  const Experiment e = prepare(s, 0.01);
  double most = 0.0;
  for (std::size_t i = 100; i + 100 < e.motion.size(); ++i) {
    const double inertia = 0.008 * SimulatedActuator::deflection(e.motion.t[i]).bend +
                           0.008 * SimulatedActuator::output(e.motion.t[i]).bend;
    most = std::max(most,
                    std::abs(rig.gain * e.motion.current[i] - rig.k * e.motion.theta[i] - inertia));
  }
  EXPECT_LT(most, 0.1 * rig.k * 0.002);
}

TEST(Experiment, DoesNotTakeTheNoiseOfAThermometerForWarmth) {
  Signals s = quiet();
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.1);
  const auto warmth = [](double t) { return 25.0 + 3.0 * (1.0 - std::exp(-t / 20.0)); };
  for (const double t : s.module.t_s)
    s.module.spring_temperature_c.push_back(warmth(t) + noise(random));
  const Experiment e = prepare(s, 0.01);
  for (std::size_t i = 0; i < e.motion.size(); ++i)
    ASSERT_NEAR(e.motion.spring_c[i], warmth(e.motion.t[i]), 0.2) << e.motion.t[i];
  double square = 0.0;
  for (std::size_t i = 400; i + 400 < e.motion.size(); ++i)
    square += std::pow(e.motion.spring_c[i] - warmth(e.motion.t[i]), 2);
  EXPECT_LT(std::sqrt(square / double(e.motion.size())), 0.015);
}

TEST(Experiment, StartsAtZeroWhateverTheClockSays) {
  Signals s = quiet();
  for (double& t : s.module.t_s) t += 5000;
  for (double& t : s.loadcell.t_s) t += 5000;
  const Experiment e = prepare(s, 0.01);
  EXPECT_EQ(e.start_s, 5000);
  EXPECT_EQ(e.motion.t.front(), 0.0);
  EXPECT_NEAR(e.loadcell_t.front(), 0.007, 1e-9);
}

TEST(Experiment, LeavesOutWhatHasNoTelemetryAroundIt) {
  Signals s = quiet();
  const auto hole = [](double t) { return t > 10 && t < 12; };
  Signals holed;
  for (std::size_t i = 0; i < s.module.t_s.size(); ++i) {
    if (hole(s.module.t_s[i])) continue;
    holed.module.t_s.push_back(s.module.t_s[i]);
    holed.module.deflection_rad.push_back(s.module.deflection_rad[i]);
  }
  holed.loadcell = s.loadcell;
  const Experiment e = prepare(holed, 0.01);
  EXPECT_FALSE(e.has_drive());
  for (std::size_t i = 0; i < e.loadcell_t.size(); ++i) {
    const double t = e.loadcell_t[i];
    EXPECT_FALSE(hole(t) && e.usable[i]) << t;
    EXPECT_TRUE(t < 1 || t > 9 || e.usable[i]) << t;
  }
}

TEST(Experiment, LeavesOutASpikeOfTheLoadcell) {
  Signals s = quiet();
  s.loadcell.torque_nm[700] += 20;
  const Experiment e = prepare(s, 0.01);
  EXPECT_FALSE(e.usable[700]);
  EXPECT_GT(std::ranges::count(e.usable, true), 0.8 * double(e.loadcell_rows()));
}

TEST(Experiment, ListensToTheDriveOnlyWhileItMoves) {
  const Experiment e = prepare(quiet(), 0.01);
  int heard = 0;
  for (Eigen::Index i = 0; i < e.drive_rows(); ++i) {
    const double t = e.drive_t[std::size_t(i)];
    const double w = SimulatedActuator::deflection(t).rate + SimulatedActuator::output(t).rate;
    const bool usable = e.usable[std::size_t(e.loadcell_rows() + i)];
    heard += usable;
    EXPECT_FALSE(usable && std::abs(w) < 0.95 * moving_rad_s) << t;
    EXPECT_TRUE(usable || std::abs(w) < 0.45 /* it may turn within the filter */ || t < 1 || t > 35)
        << t;
  }
  EXPECT_GT(heard, 1000);
}

TEST(Experiment, ThinsFastTelemetryOut) {
  SimulatedActuator rig;
  const Signals slow = rig.record();
  Signals s;
  for (int i = 0; i < 20000; ++i) {
    const double t = 0.001 * i;
    s.module.t_s.push_back(t);
    s.module.deflection_rad.push_back(SimulatedActuator::deflection(t).value);
  }
  s.loadcell = slow.loadcell;
  const Experiment e = prepare(s, 0.01);
  EXPECT_LE(double(e.motion.size()), 20 * 350.0);
  EXPECT_GE(double(e.motion.size()), 20 * 200.0);
}

TEST(Experiment, RefusesWhatHasNothingToCompare) {
  EXPECT_THROW(prepare({}, 0.01), std::invalid_argument);
  Signals s = quiet();
  s.module.deflection_rad.clear(), s.module.current_a.clear();
  EXPECT_THROW(prepare(s, 0.01), std::invalid_argument);
}

}  // namespace
}  // namespace searig::estimator
