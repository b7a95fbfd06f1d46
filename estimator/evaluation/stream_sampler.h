// sample_at() for a signal that comes sample by sample.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace searig::estimator {

/// Between samples a straight line, before the first and after the last the nearest: to the bit
/// what sample_at() gives. `at` must not fall, and must outlive this; so must the times pushed
/// rise.
class StreamSampler {
 public:
  explicit StreamSampler(std::span<const double> at) : at_(at) { values_.reserve(at.size()); }

  void push(double t, double x) {
    while (values_.size() < at_.size() && at_[values_.size()] < t)
      values_.push_back(between(at_[values_.size()], t, x));
    t_ = t, x_ = x, any_ = true;
  }

  /// All values, once everything was pushed; zeros where nothing was.
  std::vector<double> finish() {
    values_.resize(at_.size(), x_);
    return std::move(values_);
  }

 private:
  double between(double at, double t, double x) const {
    if (!any_) return x;
    const double u = (at - t_) / (t - t_);
    return u == 0.0 ? x_ : x_ + u * (x - x_);
  }

  std::span<const double> at_;
  std::vector<double> values_;
  double t_ = 0.0, x_ = 0.0;
  bool any_ = false;
};

/// How long the stretch between two samples is that each time lies in: 0 at a sample's own time,
/// infinite before the first and after the last.
class StreamGaps {
 public:
  explicit StreamGaps(std::span<const double> at) : at_(at) { gaps_.reserve(at.size()); }

  void push(double t) {
    while (gaps_.size() < at_.size() && at_[gaps_.size()] < t)
      gaps_.push_back(any_ ? (at_[gaps_.size()] == t_ ? 0.0 : t - t_) : nothing);
    t_ = t, any_ = true;
  }

  std::vector<double> finish() {
    while (gaps_.size() < at_.size())
      gaps_.push_back(any_ && at_[gaps_.size()] == t_ ? 0.0 : nothing);
    return std::move(gaps_);
  }

 private:
  static constexpr double nothing = std::numeric_limits<double>::infinity();

  std::span<const double> at_;
  std::vector<double> gaps_;
  double t_ = 0.0;
  bool any_ = false;
};

}  // namespace searig::estimator
