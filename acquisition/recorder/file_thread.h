// The thread that owns the recording's file, and the one that brings it to the disk.
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "acquisition/recorder/bounded_queue.h"
#include "acquisition/recorder/entry_sink.h"
#include "acquisition/recorder/output_file.h"
#include "acquisition/recorder/rolling_clock.h"

namespace searig::acquisition {

struct FileOptions {
  std::filesystem::path path;
  std::string program;   ///< "searig 0.1.0"
  double epoch_s = 0.0;  ///< Unix time at which the host's monotonic clock was 0

  /// Each time that long, what has come goes to the system as one chunk; a kill -9 costs that much
  /// and what the writing takes, far below the 250 ms that a chunk may have.
  double chunk_s = 0.1;
  std::uint64_t least_free_bytes = 1'000'000'000;
  std::size_t most_waiting = 200'000;  ///< entries: about a minute of 1 kHz
};

class FileThread : public EntrySink {
 public:
  /// Makes the file and says before anything is recorded what would keep it from being one: a
  /// folder that cannot be written, a file that is there, a disk with too little room. Throws
  /// std::runtime_error with one sentence.
  explicit FileThread(const FileOptions& options);
  ~FileThread() override;
  FileThread(const FileThread&) = delete;
  FileThread& operator=(const FileThread&) = delete;

  std::size_t push(std::vector<Entry>& batch) override { return queue_.push(batch, must_come); }

  /// Writes what waits, and the index; joins. Afterwards failure() is final.
  void finish();

  /// One sentence where recording must not go on; empty while all is well.
  std::string failure() const;

  std::uint64_t bytes_written() const { return bytes_written_; }
  std::optional<ClockMap> clock() const;

 private:
  void write_all();
  void estimate_clock();
  void sync_each_second();
  void check_room();
  void fail(const std::string& why);

  FileOptions options_;
  OutputFile file_;
  mcap::RecordingWriter out_;
  BoundedQueue<Entry> queue_;
  std::atomic<std::uint64_t> bytes_written_{0};

  RollingClock rolling_;

  mutable std::mutex mutex_;  // guards what follows
  std::string failure_;
  std::optional<ClockMap> clock_;
  bool done_ = false;
  std::condition_variable ended_;

  std::thread writer_, syncer_;  // last: they use all of the above
};

}  // namespace searig::acquisition
