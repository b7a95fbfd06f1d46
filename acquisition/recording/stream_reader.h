// One stream of a recording out of its CSV file.
#pragma once

#include <string_view>
#include <vector>

#include "acquisition/recording/csv.h"
#include "acquisition/recording/mapping.h"
#include "acquisition/recording/module_rows.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// Reads a stream as its mapping says: channels in SI units, rows in order of the device clock
/// within each run between restarts, everything else counted (clock/device_clock.h).
///
/// A clock is refused where more than one row in fifty would have to be taken out for the others
/// to be in order, or more than half stand still: that is no clock with some rows out of order.
/// Throws InputError that names file, line and column.
Stream read_stream(const StreamMapping& mapping);

/// A stream's rows one after the other, as read_stream() gives them, of a file that needs no
/// putting in order.
class StreamPieces {
 public:
  explicit StreamPieces(const StreamMapping& mapping);

  bool has(std::string_view channel) const;

  /// As ModuleRows has it. Throws NotInOrder where a row is damaged or its time or frame number
  /// does not rise.
  void go_through(const std::vector<std::string>& channels, const ModuleRows::Take& take) const;

 private:
  CsvFile file_;
  std::vector<ColumnMapping> columns_;  ///< t_s first
  mutable bool checked_ = false;
};

}  // namespace searig::acquisition
