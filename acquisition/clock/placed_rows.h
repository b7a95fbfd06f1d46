// The rows of a stream in order of the common clock.
#pragma once

#include <cstddef>
#include <vector>

#include "acquisition/clock/synchronise.h"

namespace searig::acquisition {

/// Rows of a stream that have a place on the module's clock, in its order, each moment once.
struct PlacedRows {
  std::vector<std::size_t> rows;  ///< row numbers of the stream
  std::vector<double> t_s;        ///< module clock; rises strictly
};

/// Rows of runs that could not be placed are left out (see ClockMap).
PlacedRows place_rows(const Stream& stream, const std::vector<RunMap>& runs);

/// A channel at those rows; empty where the stream has none.
std::vector<double> at_rows(const std::vector<double>& channel, const PlacedRows& placed);

}  // namespace searig::acquisition
