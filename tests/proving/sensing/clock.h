#pragma once

#include "tests/proving/random.h"

namespace searig::proving {

/// A device's own clock: t_device = t_true*(1 + rate_error_ppm*1e-6) + offset_s.
struct DeviceClock {
  double rate_error_ppm = 0.0, offset_s = 0.0, resolution_s = 1e-6;
  double stamp(double t_true_s) const;
  double reads(double t_true_s) const {
    return t_true_s * (1.0 + rate_error_ppm * 1e-6) + offset_s;
  }
  double true_time(double t_device_s) const {
    return (t_device_s - offset_s) / (1.0 + rate_error_ppm * 1e-6);
  }
};

/// The way from a device to the host's stamp.
struct LinkPlan {
  double least_s = 3e-4;      ///< nothing arrives sooner
  double jitter_s = 2e-4;     ///< mean of an exponential on top
  double usb_timer_s = 0.0;   ///< the adapter hands over only when its timer fires
  double stall_chance = 0.0;  ///< per sample
  double stall_s = 0.0;       ///< how long the host looks away, at most
  double loss_chance = 0.0;   ///< per sample, in bursts of one to four
};

/// Host stamps in order of arrival, whatever the delays.
class Link {
 public:
  Link(const LinkPlan& plan, Random random) : plan_(plan), random_(random) {
    // The adapter's timer has a crystal of its own: its phase wanders past every sample.
    plan_.usb_timer_s *= 1.0 + 1e-3 * random_.uniform(-1.0, 1.0);
    timer_phase_s_ = random_.uniform(0.0, plan.usb_timer_s);
  }
  double arrival(double t_true_s);
  bool lost();

 private:
  LinkPlan plan_;
  Random random_;
  double timer_phase_s_ = 0.0, last_s_ = 0.0, stalled_until_s_ = 0.0;
  int burst_ = 0;
};

}  // namespace searig::proving
