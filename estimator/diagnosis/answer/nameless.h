// What an account explains without a name.
#pragma once

#include <optional>

#include "estimator/diagnosis/answer/removed.h"

namespace searig::estimator {

/// Atoms in the final hypothesis are the mismatch that has no name; nothing where there is none.
/// `after` is what the final hypothesis leaves on held-out blocks.
std::optional<Unexplained> nameless(const Bench& bench, const Hypothesis& final,
                                    const PathResiduals& after, std::size_t atoms_tried,
                                    const Diagnosis& out);

}  // namespace searig::estimator
