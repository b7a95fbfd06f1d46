#pragma once

#include "tests/proving/rig/effect.h"
#include "tests/proving/rig/term.h"

namespace searig::proving {

/// Rate-independent torque that saturates at torque_nm; e.form chooses its mathematics:
/// "maxwell_slip", "bouc_wen" or "preisach".
std::unique_ptr<Torque> make_hysteresis(const Effect& e);

}  // namespace searig::proving
