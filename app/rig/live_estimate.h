// The online estimate followed through an experiment, for views and reports: live, replayed or
// whole.
#pragma once

#include <cstddef>

#include "app/rig/history.h"
#include "estimator/filter/online_stiffness.h"
#include "estimator/model/model.h"
#include "estimator/signals.h"

namespace searig::app {

/// The paper's settings, starting from the model's stiffness where it has one.
estimator::OnlineOptions start_from(const estimator::Model& model, double otherwise_nm_per_rad);

class LiveEstimate {
 public:
  /// The model's drive terms say what a current is worth; its spring terms are not used.
  LiveEstimate(estimator::Model model, const estimator::OnlineOptions& options);

  /// Takes up what signals have grown by since the last call; the last 50 ms wait for their
  /// neighbours unless the experiment has ended. How often it is called changes nothing. The load
  /// cell is taken anew each time, as its clock map gets better.
  void follow(const estimator::Signals& signals, bool ended = false);

  const History& history() const { return history_; }

 private:
  void take(const estimator::ModuleSignals& window, std::size_t first, std::size_t last);

  estimator::Model model_;
  estimator::OnlineStiffness filter_;
  History history_;
  std::size_t followed_ = 0;  ///< telemetry samples given to the filter
  double start_s_ = 0.0;
};

}  // namespace searig::app
