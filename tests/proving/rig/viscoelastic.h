#pragma once

#include <utility>
#include <vector>

#include "tests/proving/rig/effect.h"
#include "tests/proving/rig/term.h"

namespace searig::proving {

/// Parallel springs each in series with a dashpot: k_i*(theta - x_i), dx_i/dt = (theta -
/// x_i)/tau_i. Pairs of (k_nm_per_rad, tau_s).
std::unique_ptr<Torque> make_maxwell_branches(std::vector<std::pair<double, double>> branches);

/// e.form: "prony" with k1..k3 and tau1..tau3, or "springpot".
std::unique_ptr<Torque> make_relaxation(const Effect& e);

}  // namespace searig::proving
