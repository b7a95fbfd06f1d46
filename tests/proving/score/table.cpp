#include "tests/proving/score/table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace searig::proving {
namespace {

struct Row {
  int n = 0, named = 0, contains = 0, silent = 0, wrong = 0, alarms = 0, flagged = 0, failed = 0;
  int covered = 0, intervals = 0;
  std::vector<double> overlaps, errors, ratios, seconds;
};

Row row_of(const Judgements& all, const std::string& stratum) {
  Row r;
  for (const auto& [name, j] : all) {
    if (j.stratum != stratum) continue;
    ++r.n;
    r.named += j.named, r.contains += j.contains, r.silent += j.silent, r.wrong += j.wrong;
    r.alarms += j.alarm, r.flagged += j.unexplained, r.failed += j.failed;
    r.seconds.push_back(j.seconds);
    if (j.local) r.overlaps.push_back(j.overlap.value_or(0.0));
    for (const auto& p : j.parameters) {
      r.errors.push_back(p.relative_error);
      if (p.covered) ++r.intervals, r.covered += *p.covered;
    }
    r.ratios.insert(r.ratios.end(), j.heldout_over_reachable.begin(),
                    j.heldout_over_reachable.end());
  }
  return r;
}

std::string cell(bool meant, const char* format, double value) {
  if (!meant) return "-";
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

}  // namespace

double median(std::vector<double> v) {
  if (v.empty()) return std::nan("");
  std::sort(v.begin(), v.end());
  return 0.5 * (v[(v.size() - 1) / 2] + v[v.size() / 2]);
}

void print_table(const Judgements& all, std::ostream& out) {
  char line[240];
  const char* heads = "%-15s%5s%7s%9s%7s%7s%7s%8s%8s%8s%8s%8s%9s%8s\n";
  std::snprintf(line, sizeof line, heads, "stratum", "n", "named", "contains", "missed", "wrong",
                "alarm", "flagged", "located", "param", "cover", "ratio", "seconds", "failed");
  out << line;
  std::set<std::string> strata;
  for (const auto& [name, j] : all) strata.insert(j.stratum);
  for (const auto& s : strata) {
    const Row r = row_of(all, s);
    const bool null = s.starts_with("null"), nameless = s == "nameless", real = !null && !nameless;
    std::snprintf(
        line, sizeof line, heads, s.c_str(), std::to_string(r.n).c_str(),
        cell(real, "%.0f", r.named).c_str(), cell(real, "%.0f", r.contains).c_str(),
        cell(!null, "%.0f", r.silent).c_str(), cell(!null, "%.0f", r.wrong).c_str(),
        cell(null, "%.0f", r.alarms).c_str(), std::to_string(r.flagged).c_str(),
        cell(!r.overlaps.empty(), "%.2f", median(r.overlaps)).c_str(),
        cell(!r.errors.empty(), "%.1f%%", 100.0 * median(r.errors)).c_str(),
        cell(r.intervals > 0, "%.0f%%", 100.0 * r.covered / std::max(1, r.intervals)).c_str(),
        cell(!r.ratios.empty(), "%.2f", median(r.ratios)).c_str(),
        cell(true, "%.1f", median(r.seconds)).c_str(), std::to_string(r.failed).c_str());
    out << line;
  }
}

}  // namespace searig::proving
