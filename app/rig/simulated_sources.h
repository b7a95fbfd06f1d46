// The simulated rig as two sources of frames, for recording without hardware.
#pragma once

#include <functional>
#include <memory>

#include "acquisition/source/source.h"
#include "app/rig/simulated_rig.h"

namespace searig::app {

struct SimulatedSources {
  std::unique_ptr<acquisition::Source> module;
  std::unique_ptr<acquisition::Source> loadcell;
};

/// Both devices of one rig, whose time begins now and goes as `host_s` does. Arrivals bear the
/// rig's own stamps, so that a recording does not depend on how busy the machine is.
SimulatedSources simulated_sources(const RigSettings& settings = {},
                                   const std::function<double()>& host_s = acquisition::host_now_s);

}  // namespace searig::app
