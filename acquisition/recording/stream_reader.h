// One stream of a recording out of its CSV file.
#pragma once

#include "acquisition/recording/mapping.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// Reads a stream as its mapping says: channels in SI units, rows in order of the device clock
/// within each run between restarts, everything else counted (clock/device_clock.h).
///
/// A clock is refused where more than one row in fifty would have to be taken out for the others
/// to be in order, or more than half stand still: that is no clock with some rows out of order.
/// Throws InputError that names file, line and column.
Stream read_stream(const StreamMapping& mapping);

}  // namespace searig::acquisition
