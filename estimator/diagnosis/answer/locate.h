// Where in the recording, and over which channel, a mismatch lies.
#pragma once

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

/// What the rows lose between two hypotheses, turned into residuals' names, regions and intervals.
/// `channel` is the one the effect is local over; `path` where it enters.
Located locate(const Bench& bench, const Hypothesis& without, const Hypothesis& with, Path path,
               const std::string& channel);

/// The dense map as cells: mean of the whitened residual in the cell over its standard error.
std::vector<Cell> map_of(const Bench& bench, const std::vector<Atom>& dense,
                         const Hypothesis& before, const Hypothesis& after);

std::vector<std::string> residuals_of(Path path);

}  // namespace searig::estimator
