// A long line that jumps from point to point, so that a lost peak is seen.
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace searig::app {

struct Line {
  std::vector<double> x, y;
};

inline Line noisy_line(std::size_t size) {
  Line line;
  for (std::size_t i = 0; i < size; ++i) {
    line.x.push_back(1e-3 * (static_cast<double>(i) + 0.5));  // in the middle of a millisecond
    line.y.push_back(std::sin(12345.678 * static_cast<double>(i)));
  }
  return line;
}

}  // namespace searig::app
