// Makes an MCAP file that is there whole or not at all.
#pragma once

#include <filesystem>
#include <functional>

#include "acquisition/recorder/output_file.h"
#include "acquisition/recording/mcap/writer.h"

namespace searig::app {

/// Calls write(sink); what it sends becomes the file. Where it throws, the file is taken away
/// again: what it was made from is still there.
inline void new_mcap(const std::filesystem::path& path,
                     const std::function<void(const acquisition::mcap::Writer::Sink&)>& write) {
  acquisition::OutputFile file(path);
  try {
    write([&](std::string_view bytes) { file.append(bytes); });
    file.sync();
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(path, ignored);
    throw;
  }
}

}  // namespace searig::app
