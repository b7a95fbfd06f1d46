// The dense map: what is left of the torque, cell by cell over every channel that physics lives in.
#pragma once

#include <vector>

#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

/// Indicator cells over deflection, its rate, time since reversal, input velocity, angle, load,
/// output angle and wall time, per path. An adequate model leaves nothing that is constant in a
/// cell (L. Ljung's model error model). Cells hold at least `min_share` of the samples.
std::vector<Atom> dense_map(const Motion& motion, double min_share = 0.004);

}  // namespace searig::estimator
