// What this recording cannot decide, said from its motion alone.
#pragma once

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

/// Effects that would have to be a large part of the torque to be seen at all, and pairs that look
/// alike under this motion after everything else is refitted.
std::vector<Undecidable> undecidable(const Bench& bench, const Hypothesis& hypothesis);

}  // namespace searig::estimator
