// Rivals of the named effects: features that no catalogue entry has. Where one of them wins, the
// honest answer is `unexplained`, with the place.
#pragma once

#include <vector>

#include "estimator/diagnosis/bench.h"

namespace searig::estimator {

/// The atoms keep a reference to the motion.
std::vector<Atom> unnamed_atoms(const Motion& motion);

/// What may happen for a while, as if it went on throughout: of each kind one, to be refined.
std::vector<Atom> whole_episodes(const Motion& motion);

}  // namespace searig::estimator
