// Records a module and a load cell until it is told to stop: a thread for each, and one for the
// file.
#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "acquisition/recorder/file_thread.h"
#include "acquisition/recorder/line.h"
#include "acquisition/source/source.h"

namespace searig::acquisition {

struct RecorderOptions {
  FileOptions file;
  double seconds = std::numeric_limits<double>::infinity();
  std::string started;  ///< "2026-11-22T01:05:03Z"
  std::optional<double> lever_arm_m;
  std::optional<CountsToForce> loadcell;  ///< instead of what the load cell itself has stored
  std::string calibration;                ///< where that comes from, whole
};

/// How it stands, for people who wait.
struct RecorderState {
  double seconds = 0.0;
  WireCounters module, loadcell;
  std::optional<ClockMap> clock;
  std::uint64_t bytes_written = 0;
};

class Recorder {
 public:
  /// Makes the file. Throws std::runtime_error where that is not possible (FileThread).
  Recorder(RecorderOptions options, std::unique_ptr<Source> module,
           std::unique_ptr<Source> loadcell);

  /// Until the time is over or `stop`; calls `progress` about five times a second. The file is
  /// finished and closed in any case. Throws std::runtime_error with one sentence where it could
  /// not be recorded to the end, or nothing came from a device.
  RecorderState run(const std::atomic<bool>& stop,
                    const std::function<void(const RecorderState&)>& progress = {});

 private:
  void watch(const std::atomic<bool>& stop,
             const std::function<void(const RecorderState&)>& progress);
  void settle(double now_s);
  RecorderState state() const;
  void refuse_silence(const Line& line, const char* name) const;

  RecorderOptions options_;
  FileThread file_;
  Line module_, loadcell_;
  mcap::Settings settings_;
  double started_s_;
};

}  // namespace searig::acquisition
