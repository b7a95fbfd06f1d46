#include "estimator/twin/plant.h"

#include <gtest/gtest.h>

#include <cmath>

namespace searig::estimator::twin {
namespace {

constexpr double dt_s = 1e-4;

/// A spring that is only linear, so that torques can be said in advance.
Parameters linear() {
  Parameters parameters;
  parameters.spring.loss_stiffness_nm_per_rad = 0.0;
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

TEST(RubberSpring, SoftensByTheStatedShare) {
  SpringParameters parameters;
  RubberSpring spring(parameters);
  EXPECT_DOUBLE_EQ(spring.stiffness_nm_per_rad(), 40.0);
  for (int i = 0; i < 400000; ++i) spring.step(0.15 * std::sin(6.3e-3 * i), 1e-3);
  EXPECT_NEAR(spring.stiffness_nm_per_rad(), 30.0, 0.1);
}

TEST(RubberSpring, RelaxesToItsStiffnessAtRest) {
  SpringParameters parameters;
  parameters.softening_share = 0.0;
  RubberSpring spring(parameters);
  EXPECT_NEAR(spring.torque_nm(0.1), 4.2, 1e-12);  // (k + k1)*theta before x has moved
  for (int i = 0; i < 20000; ++i) spring.step(0.1, 1e-4);
  EXPECT_NEAR(spring.torque_nm(0.1), 4.0, 1e-4);
  EXPECT_NEAR(spring.torque_nm(spring.rest_deflection_rad()), 0.0, 1e-12);
}

}  // namespace
}  // namespace searig::estimator::twin
