#include "estimator/twin/plant.h"

#include <gtest/gtest.h>

#include <cmath>

namespace searig::estimator::twin {
namespace {

constexpr double dt_s = 1e-4;

/// A spring that is only linear, so that torques can be said in advance.
Parameters linear() {
  Parameters parameters;
  parameters.spring.branches.clear();
  parameters.spring.softening_share = 0.0;
  return parameters;
}

void hold(Plant& plant, double current_a, double hand_angle_rad, double seconds) {
  for (double t = 0.0; t < seconds; t += dt_s) plant.step(current_a, hand_angle_rad, dt_s);
}

TEST(Plant, AtRestTheHandHoldsWhatTheSpringGives) {
  Plant plant(linear());
  hold(plant, 1.0, -0.1, 3.0);
  const auto& state = plant.state();
  EXPECT_NEAR(state.train_velocity_rad_s, 0.0, 1e-9);
  EXPECT_NEAR(state.spring_torque_nm, -state.hand_torque_nm, 1e-6);
  const double theta = state.input_angle_rad - state.output_angle_rad;
  EXPECT_NEAR(state.spring_torque_nm, 40.0 * theta, 1e-9);
  EXPECT_GT(state.spring_torque_nm, 1.0);
}

// Pushed forward the train stops short by its friction; let back, it stays high by its friction.
TEST(Plant, FrictionOpposesMotion) {
  const Parameters parameters = linear();
  const double ideal =
      parameters.drive.efficiency * parameters.drive.torque_constant_nm_per_a * 1.0;
  const double friction = parameters.drive.coulomb_nm;

  Plant pushed(parameters);
  for (double current = 0.0; current < 1.0; current += 2e-5) pushed.step(current, 0.0, dt_s);
  EXPECT_NEAR(pushed.state().spring_torque_nm, ideal - friction, 0.02);

  Plant let_back(parameters);
  for (double current = 0.0; current < 2.0; current += 2e-5) let_back.step(current, 0.0, dt_s);
  for (double current = 2.0; current > 1.0; current -= 2e-5) let_back.step(current, 0.0, dt_s);
  EXPECT_NEAR(let_back.state().spring_torque_nm, ideal + friction, 0.02);
}

TEST(Plant, SticksBelowItsFriction) {
  const Parameters parameters = linear();
  const auto& drive = parameters.drive;
  const double just = drive.coulomb_nm / drive.efficiency / drive.torque_constant_nm_per_a;
  Plant sticks(parameters), slips(parameters);
  hold(sticks, 0.99 * just, 0.0, 0.5);
  hold(slips, 1.10 * just, 0.0, 0.5);
  EXPECT_EQ(sticks.state().train_angle_rad, 0.0);  // not the least bit
  EXPECT_GT(slips.state().train_angle_rad, 1e-3);
}

TEST(Plant, TheGapPassesNoTorque) {
  Parameters parameters = linear();
  parameters.drive.backlash_half_width_rad = 0.01;
  Plant plant(parameters);
  double input_moved_at = 0.0;
  while (plant.state().train_angle_rad < 0.05) {
    plant.step(0.5, 0.0, dt_s);
    const auto& state = plant.state();
    if (state.train_angle_rad < 0.0099) {
      EXPECT_EQ(state.spring_torque_nm, 0.0);
    }
    if (input_moved_at == 0.0 && state.input_angle_rad > 1e-6)
      input_moved_at = state.train_angle_rad;
  }
  EXPECT_NEAR(input_moved_at, 0.01, 1e-3);
  EXPECT_NEAR(plant.state().train_angle_rad - plant.state().input_angle_rad, 0.01, 1e-9);
}

TEST(Plant, CurrentIsLimited) {
  Plant at_limit(linear()), beyond(linear());
  hold(at_limit, 3.5, 0.0, 1.0);
  hold(beyond, 350.0, 0.0, 1.0);
  EXPECT_EQ(at_limit.state().train_angle_rad, beyond.state().train_angle_rad);
}

// Breaking away takes the Stribeck part, sliding on does not.
TEST(Plant, SticksMoreThanItSlides) {
  Parameters parameters = linear();
  parameters.drive.stribeck_nm = 0.3;
  const auto& drive = parameters.drive;
  const double sliding = drive.coulomb_nm / drive.efficiency / drive.torque_constant_nm_per_a;
  const double breaking =
      (drive.coulomb_nm + drive.stribeck_nm) / drive.efficiency / drive.torque_constant_nm_per_a;
  Plant plant(parameters);
  hold(plant, 0.99 * breaking, 0.0, 0.5);
  EXPECT_EQ(plant.state().train_angle_rad, 0.0);
  for (double hand = 0.0; plant.state().train_velocity_rad_s < 0.3; hand += 1e-4) {
    plant.step(1.5 * breaking, hand, dt_s);  // a hand that gives way
  }
  const double before = plant.state().train_velocity_rad_s;
  plant.step(sliding + (plant.state().spring_torque_nm +
                        drive.viscous_nm_s_per_rad * plant.state().train_velocity_rad_s) /
                           drive.efficiency / drive.torque_constant_nm_per_a,
             0.0, dt_s);
  EXPECT_NEAR(plant.state().train_velocity_rad_s, before, 1e-6);
}

// T*(1 + mu) to raise a load, T*(1 - mu) to let it down.
TEST(Plant, TeethRubByWhatTheyCarry) {
  Parameters parameters = linear();
  parameters.drive.coulomb_nm = 0.0;
  parameters.drive.load_friction_share = 0.2;
  const double driven =
      parameters.drive.efficiency * parameters.drive.torque_constant_nm_per_a * 1.0;

  Plant pushed(parameters);
  for (double current = 0.0; current < 1.0; current += 2e-5) pushed.step(current, 0.0, dt_s);
  EXPECT_NEAR(pushed.state().spring_torque_nm, driven / 1.2, 0.02);

  Plant let_back(parameters);
  for (double current = 0.0; current < 2.0; current += 2e-5) let_back.step(current, 0.0, dt_s);
  for (double current = 2.0; current > 1.0; current -= 2e-5) let_back.step(current, 0.0, dt_s);
  EXPECT_NEAR(let_back.state().spring_torque_nm, driven / 0.8, 0.02);
}

}  // namespace
}  // namespace searig::estimator::twin
