// From recordings to a diagnosis, with all that a report of it needs.
#pragma once

#include <optional>
#include <vector>

#include "app/session/merge.h"
#include "estimator/diagnosis/diagnosis.h"

namespace searig::app {

/// A diagnosis with what it was made from.
struct Examined {
  estimator::Diagnosis diagnosis;
  estimator::Signals signals;
  std::optional<estimator::Model> given;
  std::vector<Part> parts;
};

/// One model held against all the recordings together. What was left out of them, and clocks that
/// are not to be trusted, go into the diagnosis's notes. Throws as estimator::diagnose() does.
Examined examine(const std::vector<const Session*>& sessions, std::optional<estimator::Model> given,
                 const estimator::Progress& progress = {}, const estimator::Method& method = {});

}  // namespace searig::app
