// All effects that searig can name, simulate and fit: one per file in effects/.
#pragma once

#include <string_view>
#include <vector>

#include "estimator/physics/effect.h"

namespace searig::estimator {

/// In the order of the contract: spring, drive, rig.
const std::vector<const Effect*>& catalogue();

/// nullptr where nothing has this name.
const Effect* find_effect(std::string_view name);

}  // namespace searig::estimator
