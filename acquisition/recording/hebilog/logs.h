// The feedback in a .hebilog file, sorted by module and field.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "acquisition/recording/hebilog/frames.h"
#include "acquisition/recording/hebilog/message.h"

namespace searig::acquisition::hebilog {

/// The feedback of one module, field by field.
struct Log {
  std::vector<std::uint64_t> log_us;
  std::map<Path, std::vector<double>> fields;  ///< of the size of log_us; NaN where not sent
  std::map<Path, std::string> texts;           ///< from information: what the module is

  /// The value of the last row.
  void set(Path path, double value);

  /// The values of all rows.
  const std::vector<double>& field(Path path);
};

struct Logs {
  std::map<std::uint64_t, Log> by_address;
  Damage damage;
};

/// The modules of which there are two rows or more, and what of the file could not be read.
Logs read_logs(std::string_view bytes);

/// The log of that module, from 1, in order of their addresses; without a number, of the only one.
/// Throws InputError, half a sentence to put behind a name.
Log& chosen(Logs& logs, std::optional<std::size_t> module);

}  // namespace searig::acquisition::hebilog
