// A recording as it would have been if a model were the truth.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/session/session.h"

namespace searig::app {

struct SimulatedNoise {
  double loadcell_nm = 0.0, current_a = 0.0;  ///< standard deviations, white
  std::uint64_t seed = 1;
};

struct Simulated {
  acquisition::Recording recording;
  std::vector<std::string> notes;  ///< what could not be simulated, and why
};

/// The motion, the clocks and the sample times of `like`; the load cell reads what the model says,
/// and the current is what the model's drive needs to hold the spring's torque. Rows that have no
/// place on the common clock are left out.
Simulated simulate(const estimator::Model& model, const Session& like, const SimulatedNoise& noise);

}  // namespace searig::app
