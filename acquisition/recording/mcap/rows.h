// Messages that are rows of numbers, and a stream made of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "acquisition/recording/mcap/settings.h"
#include "acquisition/recording/recording.h"

namespace searig::acquisition::mcap {

/// Rows as they came; columns[i] belongs to names[i].
struct Rows {
  std::vector<std::string> names;
  std::vector<std::vector<double>> columns;
  std::size_t garbled = 0;  ///< rows that hold something else than finite numbers

  void take(std::string_view message);
  /// The numbers of a message for `names`; false where it holds something else than finite ones.
  bool parse(std::string_view message, std::vector<double>& row) const;
  const std::vector<double>* find(std::string_view name) const;
  std::size_t size() const { return columns.empty() ? 0 : columns.front().size(); }

 private:
  std::vector<double> row_;
};

/// All that came from a device.
struct ReceivedRows {
  Rows samples, counters, pings;
};

/// The rows as a stream. Rows that were sorted before they were written stay as they are; of a
/// recorded one they are put in order of `run` (the device's starts) and device time, as datagrams
/// may overtake each other, and the last counters say what was lost on the way.
Stream stream_of(const std::string& name, const ReceivedRows& received,
                 const StreamSettings& settings);

/// The same of rows that were in order from the first to the last, all of one `run`: `times` holds
/// t_s and host_s of it, and nothing is copied.
Stream stream_in_order(Stream times, double run, const ReceivedRows& received,
                       const StreamSettings& settings);

/// Throws InputError where a stream has no samples, or none that say anything. What was imported
/// without a load cell (a module's own log) has none.
void refuse_unusable(const Recording& recording, bool module_alone, const std::string& file);

}  // namespace searig::acquisition::mcap
