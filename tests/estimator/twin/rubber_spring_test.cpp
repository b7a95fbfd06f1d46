#include "estimator/twin/rubber_spring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace searig::estimator::twin {
namespace {

/// Works the spring with 6 N*m strokes at 1 Hz.
void work(RubberSpring& spring, double seconds) {
  for (double t = 0.0; t < seconds; t += 1e-3) {
    spring.step(0.15 * std::sin(2.0 * std::numbers::pi * t), 1e-3);
  }
}

TEST(RubberSpring, SoftensByTheStatedShare) {
  RubberSpring spring{SpringParameters{}};
  EXPECT_DOUBLE_EQ(spring.stiffness_nm_per_rad(), 40.0);
  work(spring, 400.0);
  EXPECT_NEAR(spring.stiffness_nm_per_rad(), 30.0, 0.1);
}

TEST(RubberSpring, RecoversAtRest) {
  SpringParameters parameters;
  parameters.recovery_time_s = 100.0;
  RubberSpring spring(parameters);
  work(spring, 60.0);
  const double worn = spring.worn();
  EXPECT_GT(worn, 0.8);
  for (int i = 0; i < 100000; ++i) spring.step(0.0, 1e-3);  // 100 s
  EXPECT_NEAR(spring.worn(), worn * std::exp(-1.0), 1e-3);
}

TEST(RubberSpring, BeginsAsWornAsItIsSaidToBe) {
  SpringParameters parameters;
  parameters.worn_at_start = 0.4;
  EXPECT_DOUBLE_EQ(RubberSpring(parameters).stiffness_nm_per_rad(), 40.0 * 0.9);
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

// Against the closed form: k* = k + sum_i k_i*j*w*tau_i/(1 + j*w*tau_i), loss in a cycle
// pi*Im(k*)*amplitude^2.
TEST(RubberSpring, LosesPerCycleWhatItsBranchesSay) {
  SpringParameters parameters;
  parameters.softening_share = 0.0;
  parameters.branches = {{6.0, 0.05}, {6.0, 0.5}, {6.0, 5.0}};
  const double w = 2.0 * std::numbers::pi * 0.4, amplitude = 0.1, dt_s = 1e-4;
  std::complex<double> k = parameters.stiffness_nm_per_rad;
  for (const auto& [stiffness, time_s] : parameters.branches) {
    const std::complex<double> jwt(0.0, w * time_s);
    k += stiffness * jwt / (1.0 + jwt);
  }
  RubberSpring spring(parameters);
  double loss_j = 0.0, before = 0.0;
  for (int i = 0; i < 1000000; ++i) {  // 40 cycles; the last one counts
    const double theta = amplitude * std::sin(w * i * dt_s);
    if (i >= 975000) loss_j += spring.torque_nm(theta) * (theta - before);
    spring.step(theta, dt_s);
    before = theta;
  }
  EXPECT_NEAR(loss_j, std::numbers::pi * k.imag() * amplitude * amplitude, 0.01 * loss_j);
  EXPECT_NEAR(k.imag() / k.real(), 0.08, 0.01);  // what paper_module.cpp says of them
}

}  // namespace
}  // namespace searig::estimator::twin
