// The module's motion at a rate that regression can bear.
#pragma once

#include "estimator/physics/motion.h"
#include "estimator/signals.h"

namespace searig::estimator {

/// At most 300 samples per second; angles and current have passed one filter, temperatures are
/// averaged over 2 s, an output that does not move is left out.
Motion reduced_motion(const Signals& signals);

}  // namespace searig::estimator
