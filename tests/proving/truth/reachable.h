#pragma once

#include <string>
#include <vector>

#include "tests/proving/sensing/recording.h"

namespace searig::proving {

/// Baseline terms that the owner's model lacks.
struct Concealed {
  bool coulomb = false, viscous = false, inertia = false;
  static Concealed from(const std::vector<Effect>& effects);
};

/// The baseline's numbers as least squares finds them in a recording, whatever is missing.
struct FittedNumbers {
  double stiffness_nm_per_rad = 0.0, spring_offset_nm = 0.0, torque_constant_nm_per_a = 0.0;
  double inertia_kg_m2 = 0.0, coulomb_nm = 0.0, viscous_nm_s_per_rad = 0.0;
};

struct BeforeAfter {
  double before = 0.0, after = 0.0;  ///< held out, N*m
};
struct Reachable {
  BeforeAfter spring, drive;
  FittedNumbers fitted;
  double rho() const;  ///< the effect over the noise, in the path that shows it best
};

/// Held-out errors at the load cell's samples with the true clocks known: `before` fits the
/// baseline that the owner has; `after` fits it to the same noise without the effect.
Reachable reachable(const Trace& trace, const Rig& rig, const Sensing& sensing,
                    const Recording& recording, const Concealed& concealed);

/// What of the effect no refit of the numbers and no clock shift within slack_s takes away, over
/// the noise floor, in the path that shows it best. Without noise: this is for calibration.
double visible_strength(const Trace& trace, const Rig& rig, const Recording& recording,
                        const Concealed& concealed, const Reachable& floor, double slack_s);

}  // namespace searig::proving
