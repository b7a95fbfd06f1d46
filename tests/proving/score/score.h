#pragma once

#include <filesystem>
#include <ostream>
#include <string>

#include "tests/proving/score/run.h"

namespace searig::proving {

struct ScoreOptions {
  Tool tool;
  std::filesystem::path directory;  ///< with recordings/ and answers.json
  std::string only;                 ///< one stratum, or the beginning of names
  int jobs = 2;
  bool verbose = false;
  std::filesystem::path save_results;  ///< for machines; --answers reads it back
  std::filesystem::path load_results;  ///< score these instead of running the tool
};

/// Returns the summary: reliability and targets.
nlohmann::json score(const ScoreOptions& options, std::ostream& out);

}  // namespace searig::proving
