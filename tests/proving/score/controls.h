#pragma once

#include <ostream>

#include "tests/proving/score/score.h"

namespace searig::proving {

/// The targets of the whole method beside those with one part of it left out. Each control must
/// look bad somewhere: else the data, not the method, did the work.
void controls(const ScoreOptions& options, std::ostream& out);

}  // namespace searig::proving
