#include "app/batch/page_parts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <utility>

#include "app/batch/columns.h"
#include "app/report/quantity.h"

namespace searig::app {

using nlohmann::json;

Plot over_recordings(const Summary& summary, const std::string& title, const std::string& y_label,
                     const std::vector<Curve>& curves) {
  Plot plot{.title = title, .x_label = "recording, in the order of the table", .y_label = y_label};
  plot.x_range = {0.0, double(summary.answers.size() + 1)};
  for (const Curve& curve : curves) {
    Series series{.name = curve.name, .x = {}, .y = {}, .style = Style::dots, .hue = curve.hue};
    for (std::size_t i = 0; i < summary.answers.size(); ++i) {
      const double y = number_at(summary.answers[i], curve.pointer);
      if (!std::isfinite(y)) continue;
      series.x.push_back(double(i + 1));
      series.y.push_back(y);
    }
    if (!series.x.empty()) plot.series.push_back(std::move(series));
  }
  return plot;
}

void add_figure(HtmlReport& page, const Plot& plot, const std::string& caption) {
  if (!plot.series.empty()) page.figure(plot, caption);
}

std::string only_first(std::size_t all) {
  if (all <= most_rows) return "";
  return "The first " + std::to_string(most_rows) + " of " + std::to_string(all) +
         "; all are in summary.csv.";
}

double quantile(const std::vector<double>& sorted, double q) {
  return sorted[std::size_t(q * double(sorted.size() - 1))];
}

void add_counted(HtmlReport& page, const std::string& heading, const std::string& what,
                 const std::map<std::string, std::size_t>& recordings) {
  if (recordings.empty()) return;
  std::vector<std::pair<std::string, std::size_t>> order(recordings.begin(), recordings.end());
  std::ranges::stable_sort(order, std::greater<>(), &std::pair<std::string, std::size_t>::second);
  std::vector<std::vector<std::string>> rows;
  for (const auto& [kind, count] : order) rows.push_back({kind, std::to_string(count)});
  const std::string more = only_first(rows.size());
  if (rows.size() > most_rows) rows.resize(most_rows);
  page.heading(heading);
  page.table({what, "Recordings"}, rows, more);
}

void add_worst(HtmlReport& page, const Summary& summary, const std::string& heading,
               const std::string& what, const char* pointer) {
  std::vector<std::pair<double, const json*>> order;
  for (const json& answer : summary.answers)
    if (const double value = number_at(answer, pointer); std::isfinite(value))
      order.push_back({value, &answer});
  if (order.size() < 2) return;
  std::ranges::stable_sort(order, std::greater<>(), &std::pair<double, const json*>::first);
  order.resize(std::min<std::size_t>(order.size(), 10));
  std::vector<std::vector<std::string>> rows;
  for (const auto& [value, answer] : order) rows.push_back({answer->at("path"), figures(value, 4)});
  page.heading(heading);
  page.table({"Recording", what}, rows);
}

}  // namespace searig::app
