// Something that changes for good or for a while, and that the noise has learnt to be.
#pragma once

#include <optional>

#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

/// A change that lasts is slow, and noise that is learnt with it inside takes it for a long
/// memory: under that noise nothing gains by explaining it. So windows of time are sought under
/// white noise, and the best one is weighed by how much less noise there is once it is taken out,
/// each time with the memory that the noise then has: a profile likelihood. Nothing where less than
/// a third of a residual's power goes, or where chance would do as well.
std::optional<Atom> lasting_change(const Bench& bench, const Hypothesis& hypothesis);

}  // namespace searig::estimator
