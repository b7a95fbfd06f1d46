// Refines all shapes of a hypothesis together, amplitudes eliminated (variable projection), by
// Ceres.
#pragma once

#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

/// Moves the free shape values of the pieces to the least sum of squares nearby.
/// Method: G. Golub, V. Pereyra, SIAM J. Numer. Anal. 10, 1973.
Hypothesis polish(const Bench& bench, Hypothesis hypothesis, int max_iterations = 12);

}  // namespace searig::estimator
