// Noise that is louder for a while than its surroundings explain: a cable that swings, a loose
// bolt.
#pragma once

#include <optional>

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/diagnosis/fit/bench.h"

namespace searig::estimator {

/// Seconds in which the residual is over three times as loud as load and speed let expect,
/// at least three in a row: a cable that swings, a loose bolt.
std::optional<Unexplained> loud_while(const Bench& bench, const Hypothesis& hypothesis);

/// Rows far beyond the noise that come too often for spikes: blows, slips, lost codes. Placed over
/// the channel in which they crowd most.
std::optional<Unexplained> blows(const Bench& bench, const Hypothesis& hypothesis);

/// A load-cell residual that is mostly slower than ten seconds, and not straight: its zero wanders,
/// or jumps where one step is all of it. No null of correlated noise has a memory that long.
inline constexpr const char* zero_wanders = "the load cell's zero wanders";
inline constexpr const char* zero_jumps = "the load cell's zero jumps";
std::optional<Unexplained> wanders(const Bench& bench, const Hypothesis& hypothesis);

}  // namespace searig::estimator
