// A batch's answers as files: one JSON, one table, one page.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/report/html.h"

namespace searig::app {

/// The answers of one command, in order, with those that failed among them (they have "why").
struct Summary {
  std::string command;  ///< "evaluate" or "diagnose"
  std::vector<nlohmann::json> answers;
};

/// {"format": "searig-evaluation/1" or "searig-diagnoses/1", "recordings": [...], "failed": [...]}
nlohmann::json answer_of(const Summary& summary);

/// A row for each recording, failed ones too; a field that does not apply is empty. Numbers read
/// back as they are.
std::string csv_of(const Summary& summary);

/// Stiffness and errors over the recordings, what was found by kind, what failed and why.
HtmlReport page_of(const Summary& summary);

/// evaluation.json or diagnoses.json, summary.csv, report.html into the folder, each whole or not
/// at all; what is there of an earlier run is replaced. The bytes depend on the answers alone.
/// Throws std::runtime_error with one sentence where that fails.
void write_summary(const Summary& summary, const std::filesystem::path& folder);

}  // namespace searig::app
