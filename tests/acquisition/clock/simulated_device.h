// A device that samples, a wire that delays and a host that stamps: time belongs to the test.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// device time = true time * (1 + ppm * 1e-6) + thermal wave + offset_s; host time = true time.
struct SimulatedDevice {
  double hz = 50.0;
  double seconds = 75.0;
  double ppm = 0.0;
  double offset_s = 0.0;
  double thermal_ppm = 0.0;  ///< a slow wave of the rate
  double thermal_period_s = 600.0;
  double lost_share = 0.0;
  double fixed_latency_s = 0.0;
  double mean_latency_s = 0.002;  ///< exponential, on top
  double timer_s = 0.0;           ///< the host hears only at these ticks (USB latency timer)
  double stall_share = 0.0;       ///< of rows that find the host busy
  double stall_s = 0.060;
  double resolution_s = 4e-6;  ///< of the device's counter
  double jitter_s = 5e-5;      ///< of the moment of sampling

  double device_time(double true_s) const {
    const double w = 2.0 * std::numbers::pi / thermal_period_s;
    return true_s * (1.0 + ppm * 1e-6) + thermal_ppm * 1e-6 * std::sin(w * true_s) / w + offset_s;
  }

  /// The device's own beat sets when it samples, so its rate error drifts through the host's ticks.
  double true_time_of(double beats_s) const {
    double true_s = beats_s / (1.0 + ppm * 1e-6);
    for (int i = 0; i < 3; ++i) true_s -= device_time(true_s) - offset_s - beats_s;
    return true_s;
  }

  /// Rows from true time `from` on.
  Stream run(std::mt19937_64& random, const char* name, double from = 0.0) const {
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::exponential_distribution<double> queue(1.0 / std::max(mean_latency_s, 1e-9));
    Stream stream;
    stream.name = name;
    stream.channels.push_back({"seq", {}});
    double busy_until = 0.0, heard = 0.0;
    const double start = from + 0.02 * share(random);
    const auto rows = static_cast<std::size_t>(seconds * hz);
    for (std::size_t row = 0; row < rows; ++row) {
      const double beats = start + static_cast<double>(row) / hz + jitter_s * share(random);
      const double moment = true_time_of(beats);
      if (share(random) < stall_share) busy_until = moment + stall_s * share(random);
      const double sent = moment + fixed_latency_s + queue(random);
      const double ready = std::max(sent, busy_until);
      heard = std::max(heard, timer_s > 0.0 ? std::ceil(ready / timer_s) * timer_s : ready);
      if (share(random) < lost_share) continue;
      stream.t_s.push_back(std::floor(device_time(moment) / resolution_s) * resolution_s);
      stream.host_s.push_back(heard);
      stream.channels[0].values.push_back(static_cast<double>(row));
    }
    stream.counts.received = stream.t_s.size();
    return stream;
  }
};

/// A telling pair: a module on a quiet wire and a load cell.
struct SimulatedPair {
  SimulatedDevice module{.hz = 250.0, .mean_latency_s = 0.00014};
  SimulatedDevice loadcell;

  Recording record(std::mt19937_64& random) const {
    Recording recording;
    recording.module = module.run(random, "module");
    recording.loadcell = loadcell.run(random, "loadcell");
    return recording;
  }
};

}  // namespace searig::acquisition
