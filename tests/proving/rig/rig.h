#pragma once

#include <string>
#include <vector>

#include "tests/proving/rig/effect.h"
#include "tests/proving/rig/motion.h"

namespace searig::proving {

/// What every true rig consists of. At the gear output, as in the contract:
/// T_drive = efficiency*(torque_constant*I - j*a) - coulomb - viscous.
struct Baseline {
  double stiffness_nm_per_rad = 50.0;
  double torque_constant_nm_per_a = 2.5;
  double efficiency = 0.75;
  double inertia_kg_m2 = 0.012;
  double coulomb_nm = 0.2;
  double viscous_nm_s_per_rad = 0.15;
  double gear_ratio = 349.0;
  double lever_arm_m = 0.15;
  double bristle_rad = 4e-4;  ///< travel within which dry friction turns over
};

/// The hand that holds the lever: an impedance about a place that moves.
struct Hand {
  double stiffness_nm_per_rad = 4.0;
  double damping_nm_s_per_rad = 0.3;
  double inertia_kg_m2 = 0.005;
};

/// First-order warming: tau*dT/dt = ambient + rise(loss) - T.
struct Thermal {
  double winding_tau_s = 40.0;
  double winding_rise_c_per_a2 = 8.0;
  double spring_tau_s = 60.0;
  double spring_rise_c_per_w = 4.0;
  double start_c = 25.0;
  double ambient_drift_c_per_min = 0.0;
};

struct Rig {
  Baseline base;
  Hand hand;
  Thermal thermal;
  MotionPlan plan;
  Motion motion;
  std::vector<Effect> effects;
  double duration_s = 75.0;
  double preroll_s = 1.5;  ///< motion before the recording starts: states are then not at rest

  const Effect* find(const std::string& name) const {
    for (const auto& e : effects)
      if (e.name == name) return &e;
    return nullptr;
  }
};

}  // namespace searig::proving
