// The module and the experiment of the paper, as far as the paper says what they were, and every
// number that had to be chosen beside it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "estimator/twin/parameters.h"

namespace searig::estimator::twin {

/// One trial's module: the paper's, with the spring of this seed. From one seed to the next the
/// stiffness differs as the paper's springs do, and so does how rested the rubber is.
Parameters paper_module(std::uint64_t seed);

/// The same with the nominal spring, unworn.
Parameters nominal_paper_module();

/// A number of the twin and where it comes from.
struct Fact {
  std::string what;
  std::string value;   ///< with its unit
  std::string source;  ///< where the paper says it; empty: chosen
  std::string reason;  ///< why this value, where it was chosen
};

/// All of them, in the order of the machine: spring, drive, loop, rig, sensors, motion.
std::vector<Fact> paper_module_facts();

}  // namespace searig::estimator::twin
