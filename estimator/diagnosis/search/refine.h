// Where exactly: atoms come from a coarse grid of places.
#pragma once

#include <span>
#include <utility>

#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

/// Moves an atom's borders to where it explains most beside the rest of the hypothesis. Something
/// that changes for good becomes something that lasts for a while where that explains clearly more.
Atom refined(const Bench& bench, const Hypothesis& rest, const Atom& atom);

/// The run of cells in which squares are larger than elsewhere, [first, last]: of all runs the one
/// that two variances, inside and outside, make the likeliest. `squares` are sums over `counts`
/// rows.
std::pair<std::size_t, std::size_t> loudest_run(std::span<const double> squares,
                                                std::span<const double> counts);

}  // namespace searig::estimator
