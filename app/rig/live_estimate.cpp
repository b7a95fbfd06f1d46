#include "app/rig/live_estimate.h"

namespace searig::app {

void LiveEstimate::follow(const estimator::Signals& signals, bool ended) {
  const auto& t_s = signals.module.t_s;
  if (t_s.empty()) return;
  fresh_.clear();
  stream_.follow(signals.module, ended, fresh_);
  for (const auto& estimate : fresh_) history_.append(estimate, t_s.front());
  history_.set_measured(signals.loadcell, t_s.front());
}

}  // namespace searig::app
