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

  void take(const SampleRow& row);

  /// None while there is too little to say anything.
  std::optional<ClockMap> estimate() const;

 private:
  struct Moment {
    double t_s, host_s;
  };
  struct Window {
    std::deque<Moment> moments;  ///< of one run; t_s rises
    double run = -1.0;
    void take(const SampleRow& row);
    Stream stream(const char* name) const;
  };
  Window module_, loadcell_;
};

}  // namespace searig::acquisition
