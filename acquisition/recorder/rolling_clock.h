// The clock map as it is known while recording, from the last minute of samples.
#pragma once

#include <deque>
#include <optional>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recorder/entry.h"

namespace searig::acquisition {

class RollingClock {
 public:
  static constexpr double window_s = 60.0;  ///< on the host's clock; what is older is forgotten

  /// What bears on the clocks; the rest is nothing to it. So it can be given all entries.
  void take(const Entry& entry);

  /// None while there is too little to say anything.
  std::optional<ClockMap> estimate() const;

 private:
  struct Moment {
    double t_s, host_s;
  };
  struct Window {
    std::deque<Moment> moments;  ///< of one run; t_s rises
    std::deque<Exchange> pings;  ///< of that run
    double run = -1.0;
    double least_wire_s = 0.0;
    void begin(double new_run);
    void take(const SampleRow& row);
    void take(const PingRow& row);
    Stream stream(const char* name) const;
  };
  Window& window(StreamId device) { return device == StreamId::module ? module_ : loadcell_; }
  Window module_, loadcell_;
};

}  // namespace searig::acquisition
