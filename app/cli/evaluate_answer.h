// What searig evaluate found, as JSON for machines and in a table for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "estimator/evaluation/evaluation.h"

namespace searig::app {

/// One recording's answer.
struct EvaluationOutcome {
  std::string name, path;
  estimator::Evaluation evaluation;
  std::vector<std::string> notes;
};

/// As it stands among the contract's "recordings"; with estimators asked for, it has a list of them
/// beside.
nlohmann::json answer(const EvaluationOutcome& outcome);

/// The paper's table, for people.
std::string words(const EvaluationOutcome& outcome);

}  // namespace searig::app
