#include "estimator/twin/bench.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "estimator/twin/paper_module.h"

namespace searig::estimator::twin {
namespace {

// tau*I = load*(1 + mu) + Tc + Ts*exp(-(w/ws)^2) + b*w when a load is raised.
TEST(MakersBench, EfficiencyIsTheLoadOverWhatTheMotorGives) {
  const Parameters module = nominal_paper_module();
  const auto& drive = module.drive;
  const double load = 3.0, w = 0.3;
  const double needed = load * (1.0 + drive.load_friction_share) + drive.coulomb_nm +
                        drive.stribeck_nm * std::exp(-std::pow(w / 0.05, 2)) +
                        drive.viscous_nm_s_per_rad * w;
  EXPECT_NEAR(measured_efficiency(module, load, w), load / needed, 0.005);
  EXPECT_LT(measured_efficiency(module, 1.0, w), measured_efficiency(module, 5.0, w));
}

// The paper's figure 3: about 25 % over repeated cycling.
TEST(MakersBench, CyclingSoftensTheSpringAsFigure3Says) {
  const auto cycles = cycle_spring(nominal_paper_module().spring, 0.13, 0.5, 40);
  ASSERT_EQ(cycles.stiffness_nm_per_rad.size(), 40u);
  EXPECT_TRUE(
      std::is_sorted(cycles.stiffness_nm_per_rad.rbegin(), cycles.stiffness_nm_per_rad.rend()));
  const double change =
      1.0 - cycles.stiffness_nm_per_rad.back() / cycles.stiffness_nm_per_rad.front();
  EXPECT_GT(change, 0.20);
  EXPECT_LT(change, 0.25);
}

}  // namespace
}  // namespace searig::estimator::twin
