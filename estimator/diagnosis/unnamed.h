// Rivals of the named effects: features that no catalogue entry has. Where one of them wins, the
// honest answer is `unexplained`, with the place.
#pragma once

#include <vector>

#include "estimator/diagnosis/bench.h"

namespace searig::estimator {

/// The atoms keep a reference to the motion.
std::vector<Atom> unnamed_atoms(const Motion& motion);

/// Moves an atom's borders to where it explains most beside the rest of the hypothesis.
Atom refined(const Bench& bench, const Hypothesis& rest, const Atom& atom);

}  // namespace searig::estimator
