#include "estimator/physics/catalogue.h"

#include <algorithm>

namespace searig::estimator {

// CMake writes one line per file in effects/: spring_cubic.cpp defines `const Effect&
// spring_cubic()`.
#define SEARIG_EFFECT(function) const Effect& function();
#include "effects.inc"
#undef SEARIG_EFFECT

const std::vector<const Effect*>& catalogue() {
  static const std::vector<const Effect*> all = [] {
    std::vector<const Effect*> effects = {
#define SEARIG_EFFECT(function) &function(),
#include "effects.inc"
#undef SEARIG_EFFECT
    };
    std::ranges::stable_sort(effects, {}, [](const Effect* e) { return e->path(); });
    return effects;
  }();
  return all;
}

const Effect* find_effect(std::string_view name) {
  const auto it = std::ranges::find(catalogue(), name, &Effect::name);
  return it == catalogue().end() ? nullptr : *it;
}

}  // namespace searig::estimator
