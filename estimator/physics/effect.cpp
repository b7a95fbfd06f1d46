#include "estimator/physics/effect.h"

#include <algorithm>

namespace searig::estimator {

bool Effect::has_parameter(std::string_view parameter) const {
  return std::ranges::any_of(parameters_, [&](const auto& p) { return p.name == parameter; });
}

}  // namespace searig::estimator
