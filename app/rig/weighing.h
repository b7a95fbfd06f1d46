// A reading of the load cell under a known force, for its calibration.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "acquisition/calibration/loadcell_calibration.h"

namespace searig::app {

/// The mean of a second's counts at 50 Hz, after the first few, which were on their way or still
/// swung.
class Weighing {
 public:
  explicit Weighing(double force_n) : force_n_(force_n) {}

  /// What has come since the last call; the reading, once it is whole.
  std::optional<acquisition::KnownWeight> take(const std::vector<double>& counts);

  double progress() const { return double(taken_) / double(first + enough); }

 private:
  static constexpr std::size_t first = 25, enough = 50;

  double force_n_;
  std::size_t taken_ = 0;
  double sum_ = 0.0;
};

}  // namespace searig::app
