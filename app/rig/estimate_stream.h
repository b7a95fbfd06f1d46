// The online estimate along an experiment that goes on.
#pragma once

#include <cstddef>
#include <vector>

#include "estimator/filter/online_stiffness.h"
#include "estimator/model/model.h"
#include "estimator/signals.h"

namespace searig::app {

/// The paper's settings, starting from the model's stiffness where it has one.
estimator::OnlineOptions start_from(const estimator::Model& model, double otherwise_nm_per_rad);

class EstimateStream {
 public:
  /// The model's drive terms say what a current is worth; its spring terms are not used.
  EstimateStream(estimator::Model model, const estimator::OnlineOptions& options);

  /// Takes up what the telemetry has grown by since the last call, and appends the estimates that
  /// are new; the last 50 ms wait for their neighbours unless the experiment has ended. How often
  /// it is called changes nothing.
  void follow(const estimator::ModuleSignals& module, bool ended,
              std::vector<estimator::OnlineEstimate>& estimates);

  /// So many of the oldest samples are no longer in the telemetry. At least 100 ms before the
  /// followed ones have to stay.
  void forget(std::size_t samples) { followed_ -= samples; }
  std::size_t followed() const { return followed_; }

  double k_nm_per_rad() const { return filter_.k_nm_per_rad(); }

 private:
  void take(const estimator::ModuleSignals& window, std::size_t first, std::size_t last,
            std::vector<estimator::OnlineEstimate>& estimates);

  estimator::Model model_;
  estimator::OnlineStiffness filter_;
  std::size_t followed_ = 0;  ///< telemetry samples given to the filter
};

}  // namespace searig::app
