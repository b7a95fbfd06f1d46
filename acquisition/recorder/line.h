// One device while it is heard, in a thread of its own.
#pragma once

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "acquisition/recorder/listener.h"
#include "acquisition/source/source.h"

namespace searig::acquisition {

/// Pulls from a source and gives to all who listen. A thread for each device, because looking at a
/// serial line may wait for the kernel: poll() of a terminal waits for a worker that has to share
/// the processor with everybody, and was seen to take ten seconds on a machine busy with builds. A
/// serial line keeps what comes meanwhile; a datagram socket would not.
class Line {
 public:
  Line(StreamId device, std::unique_ptr<Source> source);
  ~Line();
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  /// From now on, and from any thread. A listener that comes later is told first that the device is
  /// there.
  void add(std::shared_ptr<Listener> listener);
  /// The listener has had all that came until now, and gets no more. Waits for the line's thread,
  /// which the kernel may keep (see above).
  void remove(const std::shared_ptr<Listener>& listener);

  void start();
  /// Reads what has come until now, hands it over and ends.
  void stop();

  StreamId device() const { return device_; }
  std::string name() const { return name_; }
  unsigned baud() const { return source_->baud(); }

 private:
  void run();
  void look();
  void read();
  void ask(double now_s);
  void hand_over(double now_s);
  void let_go(double now_s);

  StreamId device_;
  std::unique_ptr<Source> source_;
  std::string name_;
  std::vector<Arrival> arrivals_;  // kept for its memory only
  std::string there_;              // what was said when the device came; empty while it is away
  std::uint32_t pings_ = 0;
  double ping_s_ = 0.0, tell_s_ = 0.0;

  std::mutex mutex_;  // guards what follows, and all that listeners are given
  std::vector<std::shared_ptr<Listener>> listeners_;
  std::vector<std::shared_ptr<Listener>> leaving_;
  std::condition_variable left_;
  bool running_ = false;

  std::atomic<bool> stop_{false};
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace searig::acquisition
