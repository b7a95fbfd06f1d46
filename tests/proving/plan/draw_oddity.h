#pragma once

#include "tests/proving/plan/draw_rig.h"

namespace searig::proving {

/// The nameless effect of this form, placed in this rig's motion; its name says it in words.
Effect draw_oddity(const std::string& form, const Rig& rig, const Statistics& stats, Random random);

}  // namespace searig::proving
