#pragma once

#include <string>

#include "tests/proving/plan/draw_rig.h"

namespace searig::proving {

/// An effect of this name (or the nameless one of this form) in one of the mathematical forms
/// that its physics is known in, at about three percent of the torque.
Effect draw_effect(const std::string& name, const Rig& rig, const Statistics& stats, Random random);

/// Bends the rig so that it has the effect: a concealed baseline term changes its number, any
/// other is added.
void give(Rig& rig, const Effect& effect);

}  // namespace searig::proving
