// What searig evaluate found, as JSON for machines and in a table for people.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "estimator/evaluation/evaluation.h"

namespace searig::app {

/// One recording's answer, or why there is none.
struct EvaluationOutcome {
  std::string name;
  estimator::Evaluation evaluation;
  std::vector<std::string> notes;
  std::string failure;
};

/// The contract's answer; with estimators asked for, each recording has a list of them beside.
nlohmann::json answer(const std::vector<EvaluationOutcome>& outcomes);

void say(const EvaluationOutcome& outcome);

}  // namespace searig::app
