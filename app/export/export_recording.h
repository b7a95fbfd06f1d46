// A recording on one clock as a file for other programs, and beside it what it was made from.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "acquisition/clock/synchronise.h"
#include "acquisition/exchange/contents.h"
#include "acquisition/recording/recording.h"

namespace searig::app {

/// Of the load cell and of the further devices, in their order.
struct Clocks {
  acquisition::ClockMap loadcell;
  std::vector<acquisition::ClockMap> devices;
};

Clocks clocks_of(const acquisition::Recording& recording);

struct ExportOptions {
  std::string format = "csv";  ///< or "mat" or "hdf5"
  bool long_form = false;      ///< csv: every value as received, one a row
  bool overwrite = false;      ///< else a file that is there is refused
};

/// Writes `out` and `out`.json: the synchronisation report and the hashes of all files. Both are
/// there whole or not at all. `program`: name and version of what writes. Throws std::runtime_error
/// with one sentence.
void export_recording(const acquisition::Recording& recording, const Clocks& clocks,
                      const acquisition::exchange::Contents& contents, const ExportOptions& options,
                      const std::filesystem::path& out, const std::string& program);

}  // namespace searig::app
