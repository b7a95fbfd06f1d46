// What the demo found: in lines for people, as JSON for machines, and as a report.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/report/html.h"
#include "app/rig/stepped_rig.h"
#include "app/session/session.h"
#include "estimator/evaluation/evaluation.h"

namespace searig::app {

struct DemoResult {
  std::filesystem::path recording;
  std::filesystem::path report;
  std::vector<std::filesystem::path> pictures;
  estimator::Evaluation poor_start;  ///< from a stiffness that is ten times too high
  estimator::Evaluation good_start;  ///< from the best fit, as in the paper's Table I
  estimator::Evaluation bare_drive;  ///< with the paper's equation (2) alone: no friction terms
  std::vector<double> truth_t_s;     ///< of the simulated spring
  std::vector<double> truth_nm_per_rad;
  double clock_error_s = 0.0;  ///< of the load cell's place at the middle, as the rig knows it
};

std::vector<std::string> describe(const Session& session, const DemoResult& result);
nlohmann::json to_json(const Session& session, const DemoResult& result);
HtmlReport demo_report(const Session& session, const SteppedRig& rig, const DemoResult& result);

}  // namespace searig::app
