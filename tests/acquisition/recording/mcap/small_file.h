// A small recording in one file, with everything that such a file can hold.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "acquisition/recording/mcap/recording_writer.h"

namespace searig::acquisition::mcap {

struct SmallFile {
  std::string bytes;
  std::vector<std::size_t> chunk_ends;  ///< bytes that a file with 1, 2, ... chunks has
  std::vector<std::size_t> module_rows, loadcell_rows;  ///< samples in so many chunks
  std::size_t first_chunk = 0;                          ///< where it begins
  double started_s = 1000.0;

  explicit SmallFile(int chunks = 4, int module_rows_each = 10, bool finished = true) {
    RecordingWriter out([&](std::string_view piece) { bytes.append(piece); }, "searig test", 1.7e9);
    first_chunk = bytes.size();
    Settings settings;
    settings.program = "searig test";
    settings.gear_ratio = 349.0;
    settings.lever_arm_m = 0.15;
    out.settings(settings, started_s);
    out.set_columns(StreamId::module, {"t_s", "host_s", "run", "deflection_rad", "current_a"});
    out.set_columns(StreamId::loadcell, {"t_s", "host_s", "run", "counts", "force_n"});
    std::size_t m = 0, l = 0;
    for (int chunk = 0; chunk < chunks; ++chunk) {
      for (int i = 0; i < module_rows_each; ++i, ++m) {
        const double t = 0.01 * double(m);
        out.raw(StreamId::module, started_s + t, "frame " + std::to_string(m));
        out.sample(StreamId::module, started_s + t,
                   std::vector{t, started_s + t, 0.0, angle(m), t});
        if (m % 5 != 0) continue;
        out.sample(StreamId::loadcell, started_s + t,
                   std::vector{t + 7.0, started_s + t, 0.0, double(l), force(l)});
        ++l;
      }
      if (chunk == 1) out.event({started_s, "module", "unplugged", "The module is gone."});
      out.counters(StreamId::module, {"host_s", "lost", "garbled"},
                   std::vector{started_s, double(chunk), 0.0});
      out.clock(started_s + 0.01 * double(m), {});
      out.file().end_chunk();
      chunk_ends.push_back(bytes.size());
      module_rows.push_back(m);
      loadcell_rows.push_back(l);
    }
    if (!finished) return;
    out.file().attach({0, 0, "notes.txt", "text/plain", "as it was"});
    out.file().add_metadata("searig", {{"program", "searig test"}});
    out.file().finish();
  }

  // Numbers that use all of their digits.
  static double angle(std::size_t row) { return 1.0 / (3.0 + double(row)); }
  static double force(std::size_t row) { return -100.0 / (7.0 + double(row)); }
};

}  // namespace searig::acquisition::mcap
