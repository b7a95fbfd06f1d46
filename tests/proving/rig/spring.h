#pragma once

#include "tests/proving/rig/rig.h"
#include "tests/proving/rig/term.h"

namespace searig::proving {

/// The torque that this effect adds to k*theta; null when it is not an effect of the spring.
std::unique_ptr<Torque> make_spring_torque(const Effect& effect, const Baseline& base);

}  // namespace searig::proving
