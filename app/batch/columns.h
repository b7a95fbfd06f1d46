// The columns of a batch's table: where each stands in a recording's answer.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace searig::app {

/// One number of an answer, where it has it: "/models/online/k_nm_per_rad". NaN where it has not.
double number_at(const nlohmann::json& answer, const std::string& pointer);

struct SummaryColumn {
  const char* name;                               ///< with its unit
  std::string (*special)(const nlohmann::json&);  ///< or nullptr:
  const char* pointer;                            ///< a number, text or truth value of the answer

  /// Empty where the answer has none.
  std::string text(const nlohmann::json& answer) const;
};

/// Of "evaluate" or "diagnose".
const std::vector<SummaryColumn>& columns_of(const std::string& command);

}  // namespace searig::app
