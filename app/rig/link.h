// How a device's samples reach the host: its own clock, and a way that takes time.
#pragma once

#include <cstdint>
#include <random>

namespace searig::app {

/// device time = true time * (1 + rate_error_ppm * 1e-6) + offset_s
struct DeviceClock {
  double rate_error_ppm = 0.0;
  double offset_s = 0.0;

  double at(double true_s) const { return true_s * (1.0 + rate_error_ppm * 1e-6) + offset_s; }
};

struct LinkSettings {
  DeviceClock clock;
  double rate_hz = 500.0;            ///< by the device's own clock
  double least_latency_s = 0.0005;   ///< what no sample undercuts
  double mean_jitter_s = 0.0003;     ///< exponential, on top
  double loss = 0.0;                 ///< share of samples that never arrive
  double device_time_step_s = 1e-6;  ///< the device's timer ticks in these
};

/// One device's samples, in order: when each is taken, what the device stamps on it, when it comes.
class Link {
 public:
  struct Passage {
    double taken_s = 0.0;    ///< true time
    double device_s = 0.0;   ///< stamped by the device
    double arrival_s = 0.0;  ///< by the host's clock, which is true time here
    bool lost = false;
  };

  Link(const LinkSettings& settings, std::uint64_t seed);

  const Passage& next() const { return next_; }
  void advance();

 private:
  LinkSettings settings_;
  std::mt19937_64 random_;
  std::uint64_t count_ = 0;
  double last_arrival_s_ = 0.0;
  Passage next_;
};

}  // namespace searig::app
