// The control loop's error in place of the motor current (the paper's section VIII).
#pragma once

#include <optional>
#include <string>

#include "estimator/signals.h"

namespace searig::estimator {

/// A position loop without an integral part asks for a current in proportion to its error:
///   I = gain (commanded angle - angle),  gain in A/rad
/// with the angle on the motor's side of the gear train where it is recorded, else the input angle.
/// Puts that in the place of the motor current; without a gain the error itself, in rad. A
/// derivative part, a limit or an integral part of the loop are not in it: the estimate is the
/// worse for it, and with an integral part worth nothing at slow motions (reference [15]).
/// Returns what is missing as one sentence, else nothing.
std::optional<std::string> take_loop_error_for_current(Signals& signals,
                                                       std::optional<double> gain_a_per_rad);

}  // namespace searig::estimator
