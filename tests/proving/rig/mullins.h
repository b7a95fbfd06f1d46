#pragma once

#include "tests/proving/rig/effect.h"
#include "tests/proving/rig/term.h"

namespace searig::proving {

/// e.form: "ogden_roxburgh" (energy) or "largest_deflection".
std::unique_ptr<Torque> make_mullins(const Effect& e, double stiffness_nm_per_rad);

}  // namespace searig::proving
