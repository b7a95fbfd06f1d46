#pragma once

#include "tests/proving/rig/rig.h"
#include "tests/proving/rig/term.h"

namespace searig::proving {

/// Between elastic presliding and full slip: -1..1, reached within about width_rad of travel.
/// Dahl 1968; the exact step for a constant velocity keeps it stable however stiff.
class Slip {
 public:
  explicit Slip(double width_rad) : width_rad_(width_rad) {}
  double advance(double velocity_rad_s, double dt_s);

 private:
  double width_rad_, state_ = 0.0;
};

/// The baseline's dry friction: no smoothing in velocity, elastic in position.
std::unique_ptr<Torque> make_coulomb(const Baseline& base);

/// The torque that this effect adds to T_drive; null when it is not an effect of the drive.
std::unique_ptr<Torque> make_drive_torque(const Effect& effect, const Baseline& base);

}  // namespace searig::proving
