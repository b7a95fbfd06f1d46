// The load cell's clock brought to the module's, with an interval and a verdict.
#pragma once

#include <string>

#include "acquisition/recording/recording.h"

namespace searig::acquisition {

/// module time = rate * loadcell time + offset_s
struct ClockMap {
  double rate = 1.0;
  double offset_s = 0.0;
  double ci95_s = 0.0;  ///< half width of the 95 % interval at the middle of the recording
  bool trusted = true;
  std::string why;  ///< one sentence: what the verdict rests on

  double to_module(double loadcell_s) const { return rate * loadcell_s + offset_s; }
};

/// Maps the load cell's clock to the module's through the host's arrival stamps.
ClockMap synchronise(const Recording& recording);

}  // namespace searig::acquisition
