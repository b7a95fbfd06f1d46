// The rows of a module's log as a stream on the module's clock.
#pragma once

#include <cstddef>
#include <vector>

#include "acquisition/recording/hebilog/logs.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition::hebilog {

/// The values in those rows.
std::vector<double> at(const std::vector<std::size_t>& rows, const std::vector<double>& values);

/// The rows in order of the module's clock, everything else counted; all else goes by `order`.
Stream stream_of(Log& log, std::vector<std::size_t>& order);

/// The four times of every feedback that has them.
void add_pings(Stream& stream, Log& log, const std::vector<std::size_t>& order);

}  // namespace searig::acquisition::hebilog
