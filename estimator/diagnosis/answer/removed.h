// How much of the mismatch a piece takes away, on blocks that no fit has seen.
#pragma once

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/diagnosis/fit/heldout.h"

namespace searig::estimator {

/// Held-out rms of one path without and with a piece, and the share of the mismatch it removes.
struct Removed {
  double before_nm = 0.0, after_nm = 0.0, share = 0.0;
};

/// In the path that the piece enters; what the rig does enters both, and counts where it does more.
Removed removed(const PathResiduals& before, const PathResiduals& after, Path path,
                const Diagnosis& out);

}  // namespace searig::estimator
