#include "app/report/extremes.h"

#include <algorithm>
#include <cmath>

namespace searig::app {
namespace {

using Found = Extremes::Found;

void add(Found& all, const Found& more, const std::vector<double>& y) {
  if (!all.whole) return;
  if (!more.whole) {
    all.whole = false;
    return;
  }
  if (y[more.lowest] < y[all.lowest]) all.lowest = more.lowest;
  if (y[more.highest] > y[all.highest]) all.highest = more.highest;
}

Found only(std::size_t i, const std::vector<double>& y) {
  return {i, i, std::isfinite(y[i])};
}

}  // namespace

void Extremes::clear() {
  for (auto& level : blocks_) level.clear();
}

void Extremes::follow(const std::vector<double>& y) {
  for (std::size_t n = blocks_[0].size(); fan * (n + 1) <= y.size(); ++n) {
    Found block = only(fan * n, y);
    for (std::size_t i = 1; i < fan; ++i) add(block, only(fan * n + i, y), y);
    blocks_[0].push_back(block);
  }
  for (std::size_t level = 1; level < levels; ++level) {
    const auto& finer = blocks_[level - 1];
    for (std::size_t n = blocks_[level].size(); fan * (n + 1) <= finer.size(); ++n) {
      Found block = finer[fan * n];
      for (std::size_t i = 1; i < fan; ++i) add(block, finer[fan * n + i], y);
      blocks_[level].push_back(block);
    }
  }
}

/// From the finest blocks upwards as long as a whole coarser block fits, then down again.
Found Extremes::in(const std::vector<double>& y, std::size_t first, std::size_t last) const {
  Found all = only(first, y);
  for (std::size_t i = first + 1; i < last && all.whole;) {
    std::size_t level = 0, size = 1;  // of the largest block that begins here and ends in time
    while (level < levels && i % (size * fan) == 0 && i + size * fan <= last &&
           i / (size * fan) < blocks_[level].size()) {
      size *= fan;
      ++level;
    }
    add(all, level == 0 ? only(i, y) : blocks_[level - 1][i / size], y);
    i += size;
  }
  return all;
}

}  // namespace searig::app
