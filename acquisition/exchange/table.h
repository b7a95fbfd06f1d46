// One table with a row for each load-cell sample, everything else brought to its time.
#pragma once

#include "acquisition/exchange/contents.h"

namespace searig::acquisition::exchange {

/// How long a pause in a stream may be for its values to be interpolated over it, in its own sample
/// intervals.
inline constexpr double longest_gap = 5.0;

/// Rows in order of the module's clock, each moment once. The module and each further device have
/// NAME_t_s (own clock, of the last row at or before t_s), NAME_age_s (from that row to t_s) and
/// NAME_valid; their channels are interpolated linearly between the rows around the sample. Where
/// there is none on one side, or the two lie further apart than longest_gap, NAME_valid is 0 and
/// the channels are NaN: nothing is held or made up. Frame numbers (seq) are the last row's.
Group table_of(Contents& contents, const Recording& recording, const ClockMap& clock,
               const std::vector<ClockMap>& devices);

}  // namespace searig::acquisition::exchange
