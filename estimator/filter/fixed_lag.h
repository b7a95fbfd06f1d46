// The rate of a streamed channel, a fixed lag behind: what live and replay compute alike.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace searig::estimator {

/// Takes samples as they come and gives each one back, half_width_s later, with the rate of its
/// deflection: the local cubic through the samples within +-half_width_s of it, at least five, as
/// differentiate() takes them. Nothing is allocated after construction.
class FixedLag {
 public:
  struct Sample {
    double t = 0;           ///< s
    double deflection = 0;  ///< rad
    double drive = 0;       ///< N*m, comes back untouched
  };
  struct Rated {
    Sample sample;
    double smooth = 0;  ///< deflection as the cubic has it, rad
    double rate = 0;    ///< rad/s
  };

  /// `capacity` samples must cover 2*half_width_s; a faster stream gets less of
  /// its window's right half.
  explicit FixedLag(double half_width_s, std::size_t capacity = 1024);

  /// False where the sample was not taken: not finite, or not later than the one before.
  bool push(const Sample& sample);

  /// The next sample whose window is complete. To be called until it has none.
  std::optional<Rated> next();

 private:
  bool complete(std::size_t& from, std::size_t& to) const;
  void forget();
  std::size_t kept_before_centre() const { return capacity_ / 4; }

  double half_width_;
  std::size_t capacity_;
  std::size_t centre_ = 0;             // next sample to give back
  std::vector<double> t_, x_, drive_;  // the last samples, oldest first
};

}  // namespace searig::estimator
