#include "app/rig/link.h"

#include <algorithm>
#include <cmath>

namespace searig::app {

Link::Link(const LinkSettings& settings, std::uint64_t seed) : settings_(settings), random_(seed) {
  advance();
}

void Link::advance() {
  std::exponential_distribution<double> jitter(1.0 / std::max(1e-9, settings_.mean_jitter_s));
  std::bernoulli_distribution lost(settings_.loss);

  // The device samples evenly by its own clock, so by true time it is a little fast or slow.
  const double rate = 1.0 + settings_.clock.rate_error_ppm * 1e-6;
  next_.taken_s = static_cast<double>(++count_) / (settings_.rate_hz * rate);
  const double step = settings_.device_time_step_s;
  next_.device_s = std::floor(settings_.clock.at(next_.taken_s) / step + 0.5) * step;
  // Samples queue on one wire: none overtakes the one before it.
  next_.arrival_s =
      std::max(last_arrival_s_ + 1e-6, next_.taken_s + settings_.least_latency_s + jitter(random_));
  next_.lost = lost(random_);
  last_arrival_s_ = next_.arrival_s;
}

}  // namespace searig::app
