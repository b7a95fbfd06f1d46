// The twin has play in its gears, which no term of the catalogue has.
#include <gtest/gtest.h>

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/twin/twin.h"

namespace searig::estimator {
namespace {

/// A minute of the twin at 500 Hz, its load cell at 50 Hz, on one clock.
Signals minute_of(const twin::Parameters& parameters) {
  twin::Twin rig(parameters);
  Signals s;
  for (int i = 0; i < 30000; ++i) {
    const double t = 0.002 * i;
    rig.advance_to(t);
    const auto module = rig.read_module();
    s.module.t_s.push_back(t);
    s.module.input_angle_rad.push_back(module.input_angle_rad);
    s.module.output_angle_rad.push_back(module.output_angle_rad);
    s.module.deflection_rad.push_back(module.input_angle_rad - module.output_angle_rad);
    s.module.current_a.push_back(module.current_a);
    if (i % 10 != 0) continue;
    s.loadcell.t_s.push_back(t);
    s.loadcell.torque_nm.push_back(rig.read_loadcell().force_n * parameters.lever.arm_m);
  }
  return s;
}

Model known_drive(const twin::Parameters& p) {
  Model model;
  model.set("spring.linear", "k_nm_per_rad", p.spring.stiffness_nm_per_rad);
  model.set("drive.motor", "torque_constant_nm_per_a", p.drive.torque_constant_nm_per_a);
  model.set("drive.motor", "efficiency", p.drive.efficiency);
  model.set("drive.inertia", "j_kg_m2", p.drive.inertia_kg_m2);
  model.set("drive.coulomb", "torque_nm", p.drive.coulomb_nm);
  model.set("drive.coulomb", "smoothing_rad_s", 0.01);
  model.set("drive.viscous", "b_nm_s_per_rad", p.drive.viscous_nm_s_per_rad);
  return model;
}

/// What is measured behind the play is not how the train accelerates. Taken for it, the inertia
/// came out as a sixteenth of the truth, with an interval that excluded it.
TEST(Play, IsSeenWhereTheTorqueChangesSignAndSparesTheInertia) {
  const twin::Parameters p;
  const Diagnosis d = diagnose(minute_of(p), known_drive(p));
  ASSERT_TRUE(d.unexplained);
  ASSERT_FALSE(d.unexplained->located.regions.empty()) << d.unexplained->what;
  const Region& where = d.unexplained->located.regions.front();
  EXPECT_EQ(where.channel, "deflection_rad");
  EXPECT_LT(where.from, 0.0);
  EXPECT_GT(where.to, 0.0);
  EXPECT_LT(where.to - where.from, 0.08);  // of 0.4 rad in all
  for (const ParameterEstimate& n : d.numbers)
    if (n.effect == "drive.inertia") EXPECT_TRUE(n.allows(p.drive.inertia_kg_m2)) << n.value;
}

TEST(Play, IsNotSeenWhereThereIsNone) {
  twin::Parameters p;
  p.drive.backlash_half_width_rad = 0.0;
  const Diagnosis d = diagnose(minute_of(p), known_drive(p));
  EXPECT_FALSE(d.unexplained) << d.unexplained->what;
}

}  // namespace
}  // namespace searig::estimator
