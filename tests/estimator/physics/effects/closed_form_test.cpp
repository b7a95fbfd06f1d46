// Each effect's torque against the contract's formula, written down a second time.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "../hand_made_motion.h"

namespace searig::estimator {
namespace {

struct Formula {
  Term term;
  std::function<double(const Motion&, std::size_t)> torque;
};

constexpr double k = 40, kt = 2.6, efficiency = 0.75, smoothing = 0.02;

const Formula formulas[] = {
    {{"spring.linear", {{"k_nm_per_rad", 40}}}, [](auto& m, auto i) { return k * m.theta[i]; }},
    {{"spring.viscous", {{"c_nm_s_per_rad", 0.7}}},
     [](auto& m, auto i) { return 0.7 * m.theta_rate[i]; }},
    {{"spring.cubic", {{"k3_nm_per_rad3", -90}}},
     [](auto& m, auto i) { return -90 * std::pow(m.theta[i], 3); }},
    {{"spring.temperature", {{"per_c", -0.01}, {"reference_c", 20}}},
     [](auto& m, auto i) {
       return k * (1 - 0.01 * (m.spring_c[i] - 20)) * m.theta[i] - k * m.theta[i];
     }},
    {{"spring.asymmetry", {{"share", 0.3}}},
     [](auto& m, auto i) {
       return (m.theta[i] > 0 ? k * 1.15 : k * 0.85) * m.theta[i] - k * m.theta[i];
     }},
    {{"spring.deadzone", {{"half_width_rad", 0.03}}},
     [](auto& m, auto i) {
       const double x = m.theta[i];
       const double beyond = x > 0.03 ? x - 0.03 : x < -0.03 ? x + 0.03 : 0.0;
       return k * beyond - k * x;
     }},
    {{"drive.motor", {{"torque_constant_nm_per_a", 2.6}, {"efficiency", 0.75}}},
     [](auto& m, auto i) { return efficiency * kt * m.current[i]; }},
    {{"drive.inertia", {{"j_kg_m2", 0.05}}},
     [](auto& m, auto i) { return -efficiency * 0.05 * m.a[i]; }},
    {{"drive.coulomb", {{"torque_nm", 0.4}, {"smoothing_rad_s", 0.05}}},
     [](auto& m, auto i) { return -0.4 * std::tanh(m.w[i] / 0.05); }},
    {{"drive.viscous", {{"b_nm_s_per_rad", 0.2}}}, [](auto& m, auto i) { return -0.2 * m.w[i]; }},
    {{"drive.stribeck", {{"torque_nm", 0.3}, {"velocity_rad_s", 0.1}}},
     [](auto& m, auto i) {
       return -0.3 * std::exp(-m.w[i] * m.w[i] / 0.01) * std::tanh(m.w[i] / smoothing);
     }},
    {{"drive.load_friction", {{"share", 0.1}}},
     [](auto& m, auto i) {
       return -0.1 * std::abs(m.spring_nm[i]) * std::tanh(m.w[i] / smoothing);
     }},
    {{"drive.load_friction", {{"share", 0.1}, {"backdriving_ratio", 2}}},
     [](auto& m, auto i) {  // the load drives the train where it moves against the spring's torque
       const double share = m.spring_nm[i] * m.w[i] < 0 ? 0.2 : 0.1;
       return -share * std::abs(m.spring_nm[i]) * std::tanh(m.w[i] / smoothing);
     }},
    {{"drive.ripple", {{"torque_nm", 0.2}, {"cycles_per_rad", 12}, {"phase_rad", 2.5}}},
     [](auto& m, auto i) { return -0.2 * std::sin(12 * m.q_i[i] + 2.5); }},
    {{"drive.ripple",
      {{"torque_nm", 0.2},
       {"cycles_per_rad", 12},
       {"phase_rad", 2.5},
       {"torque2_nm", 0.3},
       {"cycles2_per_rad", 24},
       {"phase2_rad", -1}}},
     [](auto& m, auto i) {
       return -0.2 * std::sin(12 * m.q_i[i] + 2.5) - 0.3 * std::sin(24 * m.q_i[i] - 1);
     }},
    {{"drive.current_offset", {{"offset_a", 0.05}}},
     [](auto& m, auto i) {
       return efficiency * kt * (m.current[i] - 0.05) - efficiency * kt * m.current[i];
     }},
    {{"drive.torque_constant_temperature", {{"per_c", -0.002}, {"reference_c", 30}}},
     [](auto& m, auto i) {
       return efficiency * kt * (1 - 0.002 * (m.winding_c[i] - 30)) * m.current[i] -
              efficiency * kt * m.current[i];
     }},
    {{"rig.zero_drift", {{"nm_per_min", 0.6}}}, [](auto& m, auto i) { return 0.6 * m.t[i] / 60; }},
    {{"rig.gravity", {{"torque_nm", 1.5}, {"phase_rad", -0.4}}},
     [](auto& m, auto i) { return -1.5 * std::sin(m.q_o[i] - 0.4); }},
    {{"rig.inertia", {{"j_kg_m2", 0.02}}}, [](auto& m, auto i) { return -0.02 * m.a_o[i]; }}};

TEST(EffectTorque, IsWhatTheContractsFormulaSays) {
  const Motion motion = hand_made_motion();
  for (const auto& [term, formula] : formulas) {
    const Eigen::VectorXd torque = torque_of(term, motion);
    ASSERT_EQ(std::size_t(torque.size()), motion.size()) << term.effect;
    double largest = 0.0;
    for (std::size_t i = 0; i < motion.size(); ++i) {
      const double expected = formula(motion, i);
      largest = std::max(largest, std::abs(expected));
      ASSERT_NEAR(torque[Eigen::Index(i)], expected, 1e-12) << term.effect << " at " << i;
    }
    EXPECT_GT(largest, 1e-3) << term.effect << ": the test moves nothing";
  }
}

TEST(EffectTorque, NeedsItsChannels) {
  const Motion whole = hand_made_motion();
  const Motion none;
  for (const auto& [term, formula] : formulas) {
    EXPECT_TRUE(find_effect(term.effect)->applies(whole)) << term.effect;
    EXPECT_FALSE(find_effect(term.effect)->applies(none)) << term.effect;
  }
  Motion cold = whole;
  cold.spring_c.clear(), cold.winding_c.clear(), cold.q_o.clear(), cold.a_o.clear();
  for (const char* name :
       {"spring.temperature", "drive.torque_constant_temperature", "rig.gravity", "rig.inertia"})
    EXPECT_FALSE(find_effect(name)->applies(cold)) << name;
  Motion idle = whole;
  idle.w.clear();
  for (const char* name : {"drive.coulomb", "drive.viscous", "drive.stribeck", "drive.ripple"})
    EXPECT_FALSE(find_effect(name)->applies(idle)) << name;
}

TEST(Deadzone, BorrowsItsAmplitudeFromTheSpring) {
  EXPECT_EQ(find_effect("spring.deadzone")->tied_to(), "spring.linear");
  for (const Effect* effect : catalogue())
    EXPECT_EQ(effect->tied_to().empty(), effect->name() != "spring.deadzone") << effect->name();
}

TEST(Friction, TakesEnergyAtEverySpeed) {
  const Motion motion = hand_made_motion();
  for (const auto& [term, formula] : formulas) {
    if (term.effect != "drive.coulomb" && term.effect != "drive.viscous" &&
        term.effect != "drive.stribeck" && term.effect != "drive.load_friction")
      continue;
    const Eigen::VectorXd torque = torque_of(term, motion);
    for (std::size_t i = 0; i < motion.size(); ++i)
      ASSERT_LE(torque[Eigen::Index(i)] * motion.w[i], 0.0) << term.effect;
  }
}

}  // namespace
}  // namespace searig::estimator
