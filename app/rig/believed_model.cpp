#include "app/rig/believed_model.h"

namespace searig::app {
namespace {

constexpr double too_high = 10.0;  // how far off the first guess of the stiffness is

}  // namespace

estimator::Model believed_model(const estimator::twin::Parameters& parameters) {
  const auto& drive = parameters.drive;
  estimator::Model model;
  model.set("spring.linear", "k_nm_per_rad", too_high * parameters.spring.stiffness_nm_per_rad);
  model.set("drive.motor", "torque_constant_nm_per_a", drive.torque_constant_nm_per_a);
  model.set("drive.motor", "efficiency", drive.efficiency);
  model.set("drive.inertia", "j_kg_m2", drive.inertia_kg_m2);
  model.set("drive.coulomb", "torque_nm", drive.coulomb_nm);
  model.set("drive.coulomb", "smoothing_rad_s", 0.01);
  model.set("drive.viscous", "b_nm_s_per_rad", drive.viscous_nm_s_per_rad);
  return model;
}

}  // namespace searig::app
