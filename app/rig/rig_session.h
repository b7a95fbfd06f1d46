// A rig while it is connected: both devices heard, followed live, recorded when told to.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "acquisition/recorder/recorder.h"
#include "app/rig/live_feed.h"
#include "app/rig/simulated_devices.h"

namespace searig::app {

struct RigOptions {
  std::string module = simulated, loadcell = simulated;  ///< names of sources
  std::string program;                                   ///< "searig 0.1.0"
  std::optional<double> lever_arm_m;                     ///< else the calibration's
  std::string calibration;                               ///< of the load cell, TOML; or empty
  std::optional<estimator::Model> model;                 ///< else, of a simulated module, its own
  DeviceOptions simulation;
};

/// How a recording stands.
struct RecordingStatus {
  bool running = false;  ///< also while its end is being written
  std::filesystem::path file;
  double seconds = 0.0;
  std::uint64_t bytes = 0;
  std::uint64_t free_bytes = 0;  ///< of the disk
  std::string failure;           ///< one sentence where the last one ended badly
};

class RigSession {
 public:
  /// Opens both devices, which for simulated ones takes half a second. Throws with one sentence.
  explicit RigSession(RigOptions options);
  /// A recording that runs is ended whole first.
  ~RigSession();
  RigSession(const RigSession&) = delete;
  RigSession& operator=(const RigSession&) = delete;

  const RigOptions& options() const { return options_; }
  LiveNews news() { return feed_->take(); }

  /// From now on into a file of its own, while the live view goes on. Throws with one sentence
  /// where the file cannot be made, or one is being recorded.
  void start_recording(const std::filesystem::path& file, const std::string& notes);
  /// Does not wait; recording().running tells when the file is whole.
  void stop_recording() { stop_ = true; }
  RecordingStatus recording() const;
  /// A mark in the recording that runs: what a user saw.
  void mark(const std::string& words);

  /// A command to a simulated device ("unplug"), or false where the device is real.
  bool command_board(const std::string& command);
  bool command_module(const std::string& command);

 private:
  acquisition::RecorderOptions recorder_options(const std::filesystem::path& file,
                                                const std::string& notes) const;
  void end_recording();

  RigOptions options_;
  std::optional<acquisition::CountsToForce> counts_to_force_;
  std::shared_ptr<acquisition::ChildProcess> module_process_, board_process_;
  std::shared_ptr<acquisition::Lines> lines_;
  std::unique_ptr<LiveFeed> feed_;

  std::unique_ptr<acquisition::Recorder> recorder_;
  std::atomic<bool> stop_{false};
  mutable std::mutex mutex_;  // guards the status
  RecordingStatus status_;
  std::thread recording_;
};

}  // namespace searig::app
