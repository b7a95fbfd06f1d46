// The diagnosis for machines, as the contract lays it down.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

#include "estimator/diagnosis/diagnosis.h"

namespace searig::app {

/// "consistent", "recalibrate", "missing_physics" or "unexplained".
const char* name_of(estimator::Verdict verdict);

/// Without "format". Beside the contract's keys: "numbers" (the refitted numbers, and what the
/// model gave), "model" (the extended model, as the model file has it), "notes", and in a finding
/// "unnamed_probability", the chance that what is missing has no name in the catalogue.
nlohmann::json to_json(const estimator::Diagnosis& diagnosis,
                       const std::optional<estimator::Model>& given);

}  // namespace searig::app
