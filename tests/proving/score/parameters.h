#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tests/proving/score/truth.h"

namespace searig::proving {

struct Parameter {
  std::string name;
  double relative_error;
  std::optional<bool> covered;  ///< by its 95 % interval, when one is given
};

/// The numbers of a finding that is true, held against the rig's own where both mean the same.
std::vector<Parameter> judge_parameters(const Truth& truth, const nlohmann::json& finding);

}  // namespace searig::proving
