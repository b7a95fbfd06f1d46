// Follows a rig while it runs, in a thread of its own, and keeps ready what a view has not seen.
#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "acquisition/recorder/recorder.h"
#include "app/rig/live_columns.h"
#include "app/rig/live_follower.h"

namespace searig::app {

/// What came since a view last asked.
struct LiveNews {
  LiveColumns more;
  /// Torque of the newest samples, with the stiffness as it is known now; their own estimate comes
  /// a tenth of a second later. Replaces what was here before.
  std::vector<double> tail_t_s, tail_nm;
  std::vector<acquisition::Event> events;
  std::optional<acquisition::ClockMap> clock;
  acquisition::Listener::Report module, loadcell;
  double now_s = 0.0;          ///< the newest sample
  double newest_host_s = 0.0;  ///< when it arrived; 0 before the first
  std::vector<double> counts;  ///< of the load cell since then, as they came

  /// When an event was, on the axis of the plots, s. Until a sample has come it is now.
  double time_of(const acquisition::Event& event) const;
};

class LiveFeed {
 public:
  /// Listens from now on; the lines may run or not. lever_arm_m, calibration: of the load cell.
  LiveFeed(std::shared_ptr<acquisition::Lines> lines, const FollowOptions& options);
  ~LiveFeed();
  LiveFeed(const LiveFeed&) = delete;
  LiveFeed& operator=(const LiveFeed&) = delete;

  /// All that is new; never waits for a device. Where nobody asks for minutes the oldest news go.
  LiveNews take();

 private:
  /// Takes entries from the lines' threads and never keeps them waiting.
  class Inbox : public acquisition::EntrySink {
   public:
    std::size_t push(std::vector<acquisition::Entry>& batch) override;
    bool take(std::vector<acquisition::Entry>& entries, double wait_s);
    void close() { queue_.close(); }

   private:
    acquisition::BoundedQueue<acquisition::Entry> queue_{60'000};
  };
  void run();

  std::shared_ptr<acquisition::Lines> lines_;
  Inbox inbox_;
  std::shared_ptr<acquisition::Listener> module_, loadcell_;
  LiveFollower follower_;  // the thread's own

  std::mutex mutex_;  // guards the news
  LiveNews news_;
  std::thread thread_;  // last: it uses all of the above
};

}  // namespace searig::app
