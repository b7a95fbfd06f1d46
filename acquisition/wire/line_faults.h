// What a bad line does to frames: for simulated devices and for tests. Pure and seeded.
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace searig::acquisition {

struct FaultShares {
  double drop = 0.0;       ///< of frames that never arrive
  double duplicate = 0.0;  ///< of frames that arrive twice
  double flip = 0.0;       ///< of bits that arrive wrong
};

class LineFaults {
 public:
  explicit LineFaults(std::uint64_t seed) : random_(seed) {}

  FaultShares shares;

  /// What comes of a frame, its ending zero included: nothing, one frame or two, perhaps damaged.
  std::vector<std::uint8_t> pass(std::span<const std::uint8_t> frame);

  std::uint64_t dropped() const { return dropped_; }
  std::uint64_t duplicated() const { return duplicated_; }
  std::uint64_t damaged() const { return damaged_; }  ///< frames with at least one wrong bit

 private:
  bool happens(double share);

  std::mt19937_64 random_;
  std::uint64_t dropped_ = 0;
  std::uint64_t duplicated_ = 0;
  std::uint64_t damaged_ = 0;
};

}  // namespace searig::acquisition
