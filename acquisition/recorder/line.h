// One device while it is recorded, in a thread of its own.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "acquisition/recorder/device_stream.h"
#include "acquisition/recorder/file_thread.h"
#include "acquisition/source/source.h"

namespace searig::acquisition {

/// Pulls from a source, decodes and hands everything to the file's thread. A thread for each
/// device, because looking at a serial line may wait for the kernel: poll() of a terminal waits for
/// a worker that has to share the processor with everybody, and was seen to take ten seconds on a
/// machine busy with builds. A serial line keeps what comes meanwhile; a datagram socket would not.
class Line {
 public:
  Line(StreamId device, std::unique_ptr<Source> source, std::optional<CountsToForce> calibration,
       FileThread& file);
  ~Line();
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  void start();
  /// Reads what has come until now, hands it over and ends.
  void stop();

  struct Report {
    WireCounters counters;
    std::optional<Identity> identity;
    std::string trouble;  ///< the last thing that kept the device from being heard
  };
  Report report() const;  ///< from any thread

  std::string name() const { return name_; }
  unsigned baud() const { return source_->baud(); }

 private:
  void run();
  void read();
  void ask(double now_s);
  void hand_over(double now_s);
  void publish();

  StreamId device_;
  std::unique_ptr<Source> source_;
  std::string name_;
  DeviceStream stream_;
  FileThread& file_;

  std::vector<Arrival> arrivals_;  // kept for its memory only
  std::vector<Entry> entries_;
  std::uint32_t pings_ = 0;
  std::size_t overflown_ = 0;
  std::string trouble_;

  mutable std::mutex mutex_;
  Report report_;
  std::atomic<bool> stop_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace searig::acquisition
