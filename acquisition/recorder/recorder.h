// Records a module and a load cell until it is told to stop: pulls from the sources, decodes,
// hands everything to the file's thread.
#pragma once

#include <atomic>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "acquisition/recorder/device_stream.h"
#include "acquisition/recorder/file_thread.h"
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
  struct Line {
    Line(StreamId which, std::unique_ptr<Source> from, std::optional<CountsToForce> calibration);
    StreamId device;
    std::unique_ptr<Source> source;
    DeviceStream stream;
    std::vector<Arrival> arrivals;  // kept for its memory only
    std::uint32_t pings = 0;
    std::string trouble;  // the last thing that kept it from being heard
  };

  void read(Line& line);
  void ask(Line& line, double now_s);
  void tell(double now_s);
  void hand_over(double now_s);
  void settle(double now_s);
  RecorderState state(double now_s) const;
  void refuse_silence(const Line& line) const;

  RecorderOptions options_;
  FileThread file_;
  Line module_, loadcell_;
  std::vector<Entry> entries_;
  mcap::Settings settings_;
  double started_s_;
  std::size_t overflown_ = 0;
};

}  // namespace searig::acquisition
