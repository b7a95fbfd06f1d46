// Records a module and a load cell into a file until it is told to stop.
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
  std::string model_toml;                 ///< what is believed of the module, or empty
  std::string notes;                      ///< the user's, on what this recording is
};

/// How it stands, for people who wait.
struct RecorderState {
  double seconds = 0.0;
  WireCounters module, loadcell;
  std::optional<ClockMap> clock;
  std::uint64_t bytes_written = 0;
};

/// The two devices of a rig, each heard in a thread of its own.
struct Lines {
  Lines(std::unique_ptr<Source> module_source, std::unique_ptr<Source> loadcell_source)
      : module(StreamId::module, std::move(module_source)),
        loadcell(StreamId::loadcell, std::move(loadcell_source)) {}

  void start();
  void stop();

  Line module, loadcell;
};

class Recorder {
 public:
  /// Makes the file. Throws std::runtime_error where that is not possible (FileThread). The lines
  /// may have run for long already: the file begins now.
  Recorder(RecorderOptions options, std::shared_ptr<Lines> lines);

  /// The same with lines of its own, which begin and end with the recording.
  Recorder(RecorderOptions options, std::unique_ptr<Source> module,
           std::unique_ptr<Source> loadcell);
  ~Recorder();

  /// Until the time is over or `stop`; calls `progress` about five times a second. The file is
  /// finished and closed in any case. Throws std::runtime_error with one sentence where it could
  /// not be recorded to the end, or nothing came from a device.
  RecorderState run(const std::atomic<bool>& stop,
                    const std::function<void(const RecorderState&)>& progress = {});

  /// Notes an event now, from any thread: what a user marks ("marker").
  void mark(const std::string& kind, const std::string& text);

 private:
  void watch(const std::atomic<bool>& stop,
             const std::function<void(const RecorderState&)>& progress);
  void settle(double now_s);
  RecorderState state() const;
  void refuse_silence(const Listener& listener, const Line& line, const char* name) const;

  RecorderOptions options_;
  FileThread file_;
  std::shared_ptr<Lines> lines_;
  bool owns_lines_ = false;
  std::shared_ptr<Listener> module_, loadcell_;
  mcap::Settings settings_;
  double started_s_;
};

}  // namespace searig::acquisition
