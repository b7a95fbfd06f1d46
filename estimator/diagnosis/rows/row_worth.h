// Which rows of an experiment count, and how much.
#pragma once

#include "estimator/diagnosis/rows/experiment.h"

namespace searig::estimator {

/// Fills `usable`: rows that the module's samples cover, away from the edges, without the load
/// cell's spikes; drive rows only while the input moves one way.
void mark_usable(Experiment& experiment);

/// While the deflection is held, the encoders' rounding does not average out: the whole hold has
/// one error of k*quantum/sqrt(12), and n rows of it are worth 1/(1 + n*error^2/noise^2) each.
/// Fills `weight`.
void weigh_holds(Experiment& experiment, const ModuleSignals& module);

}  // namespace searig::estimator
