#pragma once

#include "tests/proving/rig/effect.h"
#include "tests/proving/rig/term.h"

namespace searig::proving {

/// rig.delay, rig.lag and rig.zero_drift; null for anything else. Gravity and inertia of the
/// lever are mechanics and live in the simulation.
std::unique_ptr<Gauge> make_gauge(const Effect& effect);

}  // namespace searig::proving
