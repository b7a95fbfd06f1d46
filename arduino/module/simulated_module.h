// An actuator module that is not there: the twin behind a module's own clock and the wire's frames.
// Pure: its time is whatever the caller says.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "arduino/firmware/payloads.h"
#include "estimator/twin/twin.h"

namespace searig::module {

struct ModuleSettings {
  double rate_hz = 500.0;  ///< by the module's own clock
  double skew_ppm = 14.0;  ///< how much too fast that runs
  double clock_s = 437.5;  ///< what it shows at the start
  std::uint16_t boot = 0;
  std::uint64_t seed = 1;  ///< of the experiment
  double begin_s = 0.0;    ///< the experiment's time at the start
};

class SimulatedModule {
 public:
  using Bytes = std::vector<std::uint8_t>;

  explicit SimulatedModule(const ModuleSettings& settings);

  /// When the next sample is taken, true s since the start.
  double next_sample_s() const;

  /// Takes it; the frame that tells of it.
  Bytes take_sample();

  /// The answer to what came from the host in one piece: pong, identity, or nothing.
  Bytes answer(std::span<const std::uint8_t> bytes, double true_s);

  Bytes identity(double true_s);

  /// Switched off and on: clock and sequences from 0, the next boot. The experiment goes on.
  void restart(double true_s);

 private:
  double rate() const { return 1.0 + settings_.skew_ppm * 1e-6; }
  std::uint32_t device_us(double true_s) const;
  template <typename Payload>
  Bytes frame(wire::Type type, const Payload& payload, double true_s);

  ModuleSettings settings_;
  estimator::twin::Twin twin_;
  double started_s_ = 0.0;     ///< true time of the last start
  std::uint64_t samples_ = 0;  ///< since then
  std::array<std::uint32_t, 5> sequences_{};
};

}  // namespace searig::module
