#pragma once

#include "tests/proving/plan/draw_effect.h"
#include "tests/proving/truth/located.h"
#include "tests/proving/truth/reachable.h"

namespace searig::proving {

/// One recording with everything that is true about it.
struct Case {
  Item item;
  Rig rig;  ///< with the effects in
  Sensing sensing;
  std::vector<Effect> concealed;  ///< what the owner's model lacks
  Baseline believed;              ///< the owner's numbers
  Recording recording;
  Reachable reachable;
  double visible = 0.0;  ///< strength after the clock, too, was refitted
  Located located;
};

/// Deterministic in the item alone.
Case make_case(const Item& item);

}  // namespace searig::proving
