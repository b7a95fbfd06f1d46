#include "tests/proving/sensing/clock.h"

#include <algorithm>
#include <cmath>

namespace searig::proving {

double DeviceClock::stamp(double t_true_s) const {
  return std::round(reads(t_true_s) / resolution_s) * resolution_s;
}

double Link::arrival(double t_true_s) {
  double t = t_true_s + plan_.least_s + random_.exponential(plan_.jitter_s);
  if (plan_.usb_timer_s > 0.0)
    t = timer_phase_s_ + std::ceil((t - timer_phase_s_) / plan_.usb_timer_s) * plan_.usb_timer_s;
  if (random_.chance(plan_.stall_chance))
    stalled_until_s_ = t + random_.uniform(0.3, 1.0) * plan_.stall_s;
  return last_s_ = std::max({last_s_, t, stalled_until_s_});
}

bool Link::lost() {
  if (burst_ == 0 && random_.chance(plan_.loss_chance)) burst_ = random_.integer(1, 4);
  if (burst_ == 0) return false;
  --burst_;
  return true;
}

}  // namespace searig::proving
