#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace searig::proving {

struct Run {
  nlohmann::json answer;  ///< the diagnosis, or null
  std::string error;      ///< empty when there is one
  double seconds = 0.0;
};
using Runs = std::map<std::string, Run>;

struct Tool {
  std::string program;
  std::vector<std::string> extra_arguments;
  double timeout_s = 120.0;
};

/// TOOL diagnose RECORDING --json OUT, for every name, so many at once.
Runs run_all(const Tool& tool, const std::filesystem::path& recordings,
             const std::vector<std::string>& names, int jobs);

nlohmann::json to_json(const Runs& runs);
Runs runs_from(const nlohmann::json& results);

}  // namespace searig::proving
