// What the owner of the simulated module believes of it.
#pragma once

#include "estimator/model/model.h"
#include "estimator/twin/parameters.h"

namespace searig::app {

/// The data sheet's drive, which is right, and a stiffness that is ten times too high, as in the
/// paper's figures 9 to 11.
estimator::Model believed_model(const estimator::twin::Parameters& parameters);

}  // namespace searig::app
