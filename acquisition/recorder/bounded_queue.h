// Hands entries from one thread to another. Its bound is on what waits, so that a disk that stalls
// costs neither the memory nor the samples: the sender never waits.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <mutex>
#include <utility>
#include <vector>

namespace searig::acquisition {

template <typename T>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t most) : most_(most) {}

  /// Takes the batch and leaves it empty; returns how many of it are gone, for where the queue is
  /// full it takes only those that must not be: must_come(entry).
  template <typename MustCome>
  std::size_t push(std::vector<T>& batch, MustCome must_come) {
    const std::lock_guard lock(mutex_);
    std::size_t gone = 0;
    for (T& entry : batch) {
      if (waiting_.size() < most_ || must_come(entry))
        waiting_.push_back(std::move(entry));
      else
        ++gone;
    }
    batch.clear();
    return gone;
  }

  /// Nothing more will come.
  void close() {
    const std::lock_guard lock(mutex_);
    closed_ = true;
    closing_.notify_one();
  }

  /// Sleeps until then, or until the queue is closed, and takes all that waits. False where the
  /// queue is closed and empty. One wake for a whole batch: at 1 kHz that is what it costs.
  bool take_at(std::chrono::steady_clock::time_point when, std::vector<T>& taken) {
    std::unique_lock lock(mutex_);
    closing_.wait_until(lock, when, [&] { return closed_; });
    taken.clear();
    taken.swap(waiting_);
    return !(closed_ && taken.empty());
  }

 private:
  std::size_t most_;
  std::mutex mutex_;
  std::condition_variable closing_;
  std::vector<T> waiting_;
  bool closed_ = false;
};

}  // namespace searig::acquisition
