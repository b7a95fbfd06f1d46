// Rivals of the named effects: features that no catalogue entry has. Where one of them wins, the
// honest answer is `unexplained`, with the place.
#pragma once

#include <vector>

#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

/// The atoms keep a reference to the motion.
std::vector<Atom> unnamed_atoms(const Motion& motion);

/// What may change, for good or for a while: of each kind one, half-way, for refined() to place.
std::vector<Atom> lasting_changes(const Motion& motion);

}  // namespace searig::estimator
