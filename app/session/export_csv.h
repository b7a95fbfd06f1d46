// A session as CSV, for spreadsheets, MATLAB and Python.
#pragma once

#include <string>

#include "app/session/session.h"

namespace searig::app {

/// One table with a row for each load-cell sample, all on the module's clock. Comment lines (#)
/// above the header say how each column was brought there. Module channels are interpolated
/// linearly between the rows around the sample; where there is none on one side, or the two lie
/// more than five sample intervals apart, module_valid is 0 and the fields are empty: nothing is
/// held or made up. Numbers read back exactly.
std::string to_csv_table(const Session& session);

/// Every value as it was received, nothing interpolated, one per row:
/// t_s (module's clock), device_t_s, stream, channel, value.
std::string to_csv_long(const Session& session);

}  // namespace searig::app
