// An export as CSV: a table for spreadsheets, and a long form that holds everything.
#pragma once

#include <functional>
#include <string_view>

#include "acquisition/exchange/contents.h"

namespace searig::acquisition::exchange {

/// Takes pieces of a file, in order, none of them longer than about a megabyte.
using Sink = std::function<void(std::string_view)>;

/// The table (table.h). Lines that begin with # stand above the header: how each column was brought
/// to its row, the clock and its interval. A missing value is an empty field. Numbers read back
/// exactly. Throws InputError where there is no load cell, whose times the rows are on.
void write_csv_table(const Contents& contents, const Sink& sink);

/// Every value as it was received, one per row: t_s, device_t_s, stream, channel, value. A sample's
/// rows stand together, streams one after the other; t_s is empty where it is not known. The line
/// "# facts: " holds what is no column, so that import reads the same recording.
void write_csv_long(const Contents& contents, const Sink& sink);

inline constexpr std::string_view csv_first_line = "# searig export of ";
inline constexpr std::string_view csv_facts_line = "# facts: ";
inline constexpr std::string_view csv_long_header = "t_s,device_t_s,stream,channel,value";

/// A name without what would break a row.
std::string csv_name(std::string_view name);

/// ",module,deflection_rad,": what stands in a long row between its times and its value.
std::string csv_middle(std::string_view stream, std::string_view channel);

}  // namespace searig::acquisition::exchange
