#include "tests/proving/score/controls.h"

#include <cmath>
#include <cstdio>
#include <limits>
#include <sstream>
#include <vector>

namespace searig::proving {
namespace {

using nlohmann::json;

const std::vector<std::string> names{"no-noise-model", "no-adequacy-test", "adapting-stiffness"};

struct Column {
  std::string name;
  json targets;
};

Column run(ScoreOptions options, const std::string& control) {
  if (!control.empty()) options.tool.extra_arguments.push_back("--control=" + control);
  if (!options.save_results.empty() && !control.empty())
    options.save_results.replace_filename(control + "-" + options.save_results.filename().string());
  std::ostringstream unseen;
  return {control.empty() ? "whole method" : control, score(options, unseen)["targets"]};
}

std::string cell(const json& target) {
  if (target["measured"].is_null()) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%s%.3f", target["met"].get<bool>() ? "" : "! ",
                target["measured"].get<double>());
  return text;
}

}  // namespace

void controls(const ScoreOptions& options, std::ostream& out) {
  std::vector<Column> columns{run(options, "")};
  for (const auto& name : names) columns.push_back(run(options, name));
  char line[200];
  std::snprintf(line, sizeof line, "%-38s %-12s", "! where a target is missed", "target");
  out << line;
  for (const auto& column : columns) {
    std::snprintf(line, sizeof line, " %18s", column.name.c_str());
    out << line;
  }
  out << '\n';
  for (std::size_t i = 0; i < columns.front().targets.size(); ++i) {
    const json& first = columns.front().targets[i];
    if (first["measured"].is_null()) continue;
    std::snprintf(line, sizeof line, "%-38s %-12s", first["what"].get<std::string>().c_str(),
                  first["target"].get<std::string>().c_str());
    out << line;
    for (const auto& column : columns) {
      std::snprintf(line, sizeof line, " %18s", cell(column.targets[i]).c_str());
      out << line;
    }
    out << '\n';
  }
}

}  // namespace searig::proving
