#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace searig::proving {

/// xoshiro256** (Blackman & Vigna 2018). The standard library's distributions differ between
/// implementations; a sealed recording must have the same bytes everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed);

  /// An independent stream: drawing more of one thing never moves another.
  Random fork(std::string_view purpose) const;

  std::uint64_t bits();
  double uniform(double low = 0.0, double high = 1.0);
  double log_uniform(double low, double high);
  double normal();
  double exponential(double mean);
  int integer(int low, int high);  ///< both ends included
  bool chance(double probability) { return uniform() < probability; }
  double sign() { return chance(0.5) ? 1.0 : -1.0; }

  template <typename T>
  const T& pick(const std::vector<T>& from) {
    return from[static_cast<std::size_t>(integer(0, static_cast<int>(from.size()) - 1))];
  }

 private:
  std::uint64_t seed_;
  std::uint64_t state_[4];
};

}  // namespace searig::proving
