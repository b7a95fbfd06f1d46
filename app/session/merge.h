// Several recordings of one rig as one, so that one model is held against them all.
#pragma once

#include <string>
#include <vector>

#include "app/session/session.h"

namespace searig::app {

/// Where a recording lies in the merged one, s on its module clock.
struct Part {
  std::string name;
  double from_s = 0.0, to_s = 0.0;
};

/// Of the recordings together, without the rests between them.
double seconds_of(const std::vector<Part>& parts);

struct Merged {
  estimator::Signals signals;
  std::vector<Part> parts;
  std::vector<std::string> notes;  ///< what was left out, and why
};

/// Rest between two recordings in the merged one: longer than most memories of a spring.
inline constexpr double gap_between_s = 20.0;

/// Puts the recordings one behind the other, gap_between_s apart. A channel that one of them lacks
/// is left out of all. The widest of their clock intervals holds. One recording stays as it is.
Merged merge(const std::vector<const Session*>& sessions);

}  // namespace searig::app
