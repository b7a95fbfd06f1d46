// One piece of work per item on several threads; what comes out does not depend on how many.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace searig::app {

/// Calls work(0) .. work(count - 1), each once, on up to `jobs` threads (0: one for each core).
/// work must not throw, and must write only what belongs to its own item.
template <class Work>
void in_parallel(std::size_t count, unsigned jobs, Work&& work) {
  if (jobs == 0) jobs = std::max(1u, std::thread::hardware_concurrency());
  std::atomic<std::size_t> next = 0;
  const auto take_items = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::jthread> helpers;
  for (std::size_t j = 1; j < std::min<std::size_t>(jobs, count); ++j) {
    helpers.emplace_back(take_items);
  }
  take_items();
}

}  // namespace searig::app
