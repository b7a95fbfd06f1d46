// The online estimate followed through an experiment and kept, for reports: replayed or whole.
#pragma once

#include <utility>
#include <vector>

#include "app/rig/estimate_stream.h"
#include "app/rig/history.h"

namespace searig::app {

class LiveEstimate {
 public:
  LiveEstimate(estimator::Model model, const estimator::OnlineOptions& options)
      : stream_(std::move(model), options) {}

  /// Takes up what signals have grown by (EstimateStream). The load cell is taken anew each time,
  /// as its clock map gets better.
  void follow(const estimator::Signals& signals, bool ended = false);

  const History& history() const { return history_; }

 private:
  EstimateStream stream_;
  std::vector<estimator::OnlineEstimate> fresh_;
  History history_;
};

}  // namespace searig::app
