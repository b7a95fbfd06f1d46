#include "estimator/model/predict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace searig::estimator {
namespace {

/// Angles that are cubics in time: the differentiator is exact on them.
struct HandMade {
  ModuleSignals module;
  static double theta(double t) { return 0.1 * t - 0.05 * t * t; }
  static double theta_rate(double t) { return 0.1 - 0.1 * t; }
  static double q_o(double t) { return 0.2 * t * t * t - 0.3; }
  static double a_o(double t) { return 1.2 * t; }
  static double w(double t) { return theta_rate(t) + 0.6 * t * t; }
  static double a(double t) { return -0.1 + 1.2 * t; }
  static double current(double t) { return 0.5 + t; }

  HandMade() {
    for (int i = 0; i < 1000; ++i) {
      const double t = 0.002 * i;
      module.t_s.push_back(50 + t);
      module.deflection_rad.push_back(theta(t));
      module.input_angle_rad.push_back(theta(t) + q_o(t));
      module.output_angle_rad.push_back(q_o(t));
      module.current_a.push_back(current(t));
    }
  }
  double t(std::size_t i) const { return module.t_s[i] - 50; }
};

Model actuator() {
  Model m;
  m.terms = {{"spring.linear", {{"k_nm_per_rad", 40}}},
             {"spring.viscous", {{"c_nm_s_per_rad", 2}}},
             {"drive.motor", {{"torque_constant_nm_per_a", 2.6}, {"efficiency", 0.75}}},
             {"drive.inertia", {{"j_kg_m2", 0.3}}},
             {"drive.coulomb", {{"torque_nm", 0.25}, {"smoothing_rad_s", 0.5}}},
             {"drive.stribeck", {{"torque_nm", 0.1}, {"velocity_rad_s", 0.4}}}};
  return m;
}

TEST(Predict, SumsTheSpringAndTheDriveByTheContract) {
  const HandMade rig;
  const Torques out = predict(actuator(), rig.module);
  ASSERT_EQ(out.spring_nm.size(), 1000u);
  ASSERT_EQ(out.drive_nm.size(), 1000u);
  for (std::size_t i = 0; i < 1000; ++i) {
    const double t = rig.t(i), w = HandMade::w(t);
    ASSERT_NEAR(out.spring_nm[i], 40 * HandMade::theta(t) + 2 * HandMade::theta_rate(t), 1e-6);
    // Stribeck friction turns its sign over the same speed as the Coulomb friction: 0.5 rad/s.
    const double friction =
        0.25 * std::tanh(w / 0.5) + 0.1 * std::exp(-w * w / 0.16) * std::tanh(w / 0.5);
    ASSERT_NEAR(out.drive_nm[i],
                0.75 * (2.6 * HandMade::current(t) - 0.3 * HandMade::a(t)) - friction, 1e-5);
  }
}

TEST(Predict, TakesTheRigsTermsAwayBetweenSpringAndLoadcell) {
  const HandMade rig;
  Model m = actuator();
  m.set("rig.inertia", "j_kg_m2", 0.1);
  m.set("rig.gravity", "torque_nm", 1.5);
  m.set("rig.gravity", "phase_rad", 0.2);
  m.set("rig.zero_drift", "nm_per_min", 6);
  const Torques out = predict(m, rig.module);
  for (std::size_t i = 0; i < 1000; ++i) {
    const double t = rig.t(i);
    const double taken =
        0.1 * HandMade::a_o(t) + 1.5 * std::sin(HandMade::q_o(t) + 0.2) - 6 * t / 60;
    ASSERT_NEAR(out.rig_nm[i], taken, 1e-6);
    ASSERT_NEAR(out.loadcell_nm[i], out.spring_nm[i] - taken, 1e-6);
  }
}

TEST(Predict, ShowsTheLoadcellLate) {
  const HandMade rig;
  Model m;
  m.set("spring.linear", "k_nm_per_rad", 40);
  m.set("rig.delay", "delay_s", 0.1);
  m.set("rig.lag", "tau_s", 0.05);
  const Torques out = predict(m, rig.module);
  for (std::size_t i = 500; i < 1000; ++i) {
    // A parabola through a lag comes late by tau and bent up by tau^2 times its second derivative.
    const double t = rig.t(i) - 0.1 - 0.05;
    ASSERT_NEAR(out.loadcell_nm[i], 40 * (HandMade::theta(t) - 0.05 * 0.05 * 0.05), 1e-3);
  }
}

TEST(Predict, SoftensByTheTorqueItself) {
  const HandMade rig;
  Model m;
  m.set("spring.linear", "k_nm_per_rad", 40);
  m.set("spring.mullins", "share", 0.3);
  m.set("spring.mullins", "scale", 0.05);
  const Torques out = predict(m, rig.module);
  const double theta = HandMade::theta(1.0), work = 0.5 * 40 * theta * theta;
  EXPECT_NEAR(out.spring_nm[500], 40 * theta * (1 - 0.3 * (1 - std::exp(-work / 0.05))), 5e-3);
}

TEST(Predict, GivesNoTorqueThatTheRecordingCannotTell) {
  ModuleSignals module = HandMade().module;
  module.current_a.clear();
  EXPECT_TRUE(predict(actuator(), module).drive_nm.empty());
  EXPECT_FALSE(predict(actuator(), module).spring_nm.empty());
  module.deflection_rad.clear();
  EXPECT_TRUE(predict(actuator(), module).spring_nm.empty());
  EXPECT_TRUE(predict(actuator(), module).loadcell_nm.empty());
}

TEST(Predict, LeavesOutATermThatLacksItsChannel) {
  const HandMade rig;
  Model m = actuator();
  const auto without = predict(m, rig.module);
  m.set("spring.temperature", "per_c", -0.01);
  m.set("spring.temperature", "reference_c", 20);
  EXPECT_EQ(predict(m, rig.module).spring_nm, without.spring_nm);
}

TEST(SampleAt, InterpolatesAndHoldsTheEnds) {
  const std::vector<double> t{0, 1, 3}, x{10, 20, 0};
  EXPECT_EQ(sample_at(t, x, {-1, 0, 0.5, 1, 2, 3, 9}),
            (std::vector<double>{10, 10, 15, 20, 10, 0, 0}));
  EXPECT_EQ(sample_at({}, {}, {1}), std::vector<double>{0});
}

}  // namespace
}  // namespace searig::estimator
