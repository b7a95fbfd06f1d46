// A 95 % interval beside the paper's online stiffness, which has none of its own.
#pragma once

#include <memory>
#include <optional>

#include "estimator/filter/online_stiffness.h"
#include "estimator/filter/state_estimator.h"

namespace searig::app {

/// Follows the same samples with the same trust by the linear estimator (docs/estimator.md), whose
/// intervals hold what does not hang together longer than its blocks; what the model has wrong is
/// in neither.
class StiffnessInterval {
 public:
  explicit StiffnessInterval(double initial_k_nm_per_rad);

  void take(const estimator::OnlineEstimate& sample);

  struct Interval {
    double low, high;  ///< N*m/rad
  };
  /// Nothing while too little is known.
  std::optional<Interval> interval() const { return interval_; }

 private:
  void ask();

  std::unique_ptr<estimator::StateEstimator> filter_;
  std::optional<Interval> interval_;
  double last_s_, asked_s_;
};

}  // namespace searig::app
