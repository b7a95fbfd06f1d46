// A batch's page of evaluations: how the numbers spread, and their curves.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/batch/columns.h"
#include "app/batch/page_parts.h"
#include "app/report/quantity.h"

namespace searig::app {
namespace {

using nlohmann::json;

std::vector<double> sorted_numbers(const Summary& summary, const char* pointer) {
  std::vector<double> values;
  for (const json& answer : summary.answers)
    if (const double value = number_at(answer, pointer); std::isfinite(value))
      values.push_back(value);
  std::ranges::sort(values);
  return values;
}

std::string quantile_words(const std::vector<double>& sorted, double share) {
  return figures(quantile(sorted, share), 4);
}

/// How a number spreads over the recordings, as a row; nothing where none has it.
void add_spread(std::vector<std::vector<std::string>>& rows, const Summary& summary,
                const std::string& what, const char* pointer) {
  const auto sorted = sorted_numbers(summary, pointer);
  if (sorted.empty()) return;
  rows.push_back({what, std::to_string(sorted.size()), quantile_words(sorted, 0.0),
                  quantile_words(sorted, 0.05), quantile_words(sorted, 0.5),
                  quantile_words(sorted, 0.95), quantile_words(sorted, 1.0)});
}

void add_spreads(HtmlReport& page, std::vector<std::vector<std::string>> rows) {
  if (rows.empty()) return;
  page.table({"", "Recordings", "Least", "5 %", "Middle", "95 %", "Most"}, rows);
}

}  // namespace

void add_evaluations(HtmlReport& page, const Summary& summary) {
  const char *best_k = "/models/best_fit/k_nm_per_rad", *online_k = "/models/online/k_nm_per_rad",
             *best = "/models/best_fit/error_percent", *online = "/models/online/error_percent",
             *current = "/models/current/error_percent";
  std::vector<std::vector<std::string>> rows;
  add_spread(rows, summary, "Stiffness, best fit (N·m/rad)", best_k);
  add_spread(rows, summary, "Stiffness, online, at the end (N·m/rad)", online_k);
  add_spread(rows, summary, "Error of the best fit (%)", best);
  add_spread(rows, summary, "Error of the online estimate (%)", online);
  add_spread(rows, summary, "Error of the motor current (%)", current);
  add_spreads(page, rows);
  page.heading("Stiffness over the recordings");
  add_figure(page,
             over_recordings(summary, "", "stiffness (N·m/rad)",
                             {{"best fit to the load cell", best_k, Hue::ink},
                              {"online, at the end", online_k, Hue::blue}}),
             "The spring's stiffness: what fits the load cell best, and what the online estimate "
             "came to from the motor current.");
  page.heading("Errors over the recordings");
  add_figure(page,
             over_recordings(summary, "", "error (%)",
                             {{"motor current", current, Hue::vermilion},
                              {"online", online, Hue::blue},
                              {"best fit", best, Hue::ink}}),
             "Mean |estimate - measured| over mean |measured| torque, at the load cell's samples.");
  add_worst(page, summary, "Where the online estimate is worst", "Error (%)", online);
}

}  // namespace searig::app
