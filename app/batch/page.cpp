// A batch on one page: the curves first, then what was found, by kind, and what failed.
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "app/batch/columns.h"
#include "app/batch/summary.h"
#include "app/report/diagnosis_words.h"
#include "app/report/quantity.h"

namespace searig::app {
namespace {

using nlohmann::json;

constexpr std::size_t most_rows = 20;  // of a table on the page; all of them are in summary.csv

struct Curve {
  const char* name;
  const char* pointer;
  Hue hue;
};

/// One dot for each recording that has the number.
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

std::vector<double> sorted_numbers(const Summary& summary, const char* pointer) {
  std::vector<double> values;
  for (const json& answer : summary.answers)
    if (const double value = number_at(answer, pointer); std::isfinite(value))
      values.push_back(value);
  std::ranges::sort(values);
  return values;
}

std::string quantile_words(const std::vector<double>& sorted, double share) {
  return figures(sorted[std::size_t(share * double(sorted.size() - 1))], 4);
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

/// Sentences that differ in their numbers only are of one kind: each run of digits becomes N.
std::string kind_of(const std::string& sentence) {
  std::string kind;
  for (std::size_t i = 0; i < sentence.size(); ++i) {
    const bool digit = std::isdigit(static_cast<unsigned char>(sentence[i])) != 0;
    const bool goes_on = !kind.empty() && kind.back() == 'N' && i > 0 &&
                         std::isdigit(static_cast<unsigned char>(sentence[i - 1]));
    if (!digit)
      kind += sentence[i];
    else if (!goes_on)
      kind += 'N';
  }
  return kind;
}

/// Kinds with how often each came, the most frequent first.
std::vector<std::vector<std::string>> counted(const std::map<std::string, std::size_t>& counts) {
  std::vector<std::pair<std::string, std::size_t>> order(counts.begin(), counts.end());
  std::ranges::stable_sort(order, std::greater<>(), &std::pair<std::string, std::size_t>::second);
  std::vector<std::vector<std::string>> rows;
  for (const auto& [kind, count] : order) rows.push_back({kind, std::to_string(count)});
  if (rows.size() > most_rows) rows.resize(most_rows);
  return rows;
}

void add_notes(HtmlReport& page, const Summary& summary) {
  std::map<std::string, std::size_t> counts;
  for (const json& answer : summary.answers)
    for (const json& note : answer.value("notes", json::array())) ++counts[kind_of(note)];
  if (counts.empty()) return;
  page.heading("Notes by kind");
  page.table({"Note", "Recordings"}, counted(counts));
}

void add_failed(HtmlReport& page, const Summary& summary) {
  std::vector<std::vector<std::string>> rows;
  std::size_t failed = 0;
  for (const json& answer : summary.answers) {
    if (!answer.contains("why") || ++failed > most_rows) continue;
    rows.push_back({answer.at("path"), answer.at("why")});
  }
  if (failed == 0) return;
  page.heading("Failed");
  page.table({"Recording", "Why"}, rows,
             failed > most_rows ? "The first " + std::to_string(most_rows) + " of " +
                                      std::to_string(failed) + "; all are in summary.csv."
                                : "");
}

/// The recordings that a number is largest in.
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

/// Effects that were asserted, with how sure and how large.
void add_findings(HtmlReport& page, const Summary& summary) {
  std::map<std::string, std::vector<double>> found;
  std::map<std::string, std::size_t> verdicts, open;
  for (const json& answer : summary.answers) {
    if (answer.contains("why")) continue;
    ++verdicts[answer.at("verdict")];
    for (const json& finding : answer.at("findings"))
      found[finding.at("effect")].push_back(finding.at("probability"));
    std::set<std::string> here;  // an effect may be open for more than one reason
    for (const json& one : answer.at("undecidable"))
      for (const json& effect : one.at("effects")) here.insert(effect);
    for (const std::string& effect : here) ++open[effect];
  }
  page.heading("Verdicts");
  page.table({"Verdict", "Recordings"}, counted(verdicts));
  std::vector<std::vector<std::string>> rows;
  for (auto& [effect, sure] : found) {
    std::ranges::sort(sure);
    rows.push_back(
        {effect, title_of(effect), std::to_string(sure.size()), figures(sure[sure.size() / 2], 2)});
  }
  page.heading("Findings by kind");
  if (rows.empty()) page.paragraph("No physics was found missing.");
  if (!rows.empty()) page.table({"Effect", "What", "Recordings", "Middle probability"}, rows);
  if (open.empty()) return;
  page.heading("What the recordings cannot decide");
  page.table({"Effect", "Recordings"}, counted(open));
}

void add_diagnoses(HtmlReport& page, const Summary& summary) {
  add_findings(page, summary);
  const char *k = "/model/spring.linear/k_nm_per_rad",
             *given = "/paths/spring/heldout_rmse_nm/as_given",
             *before = "/paths/spring/heldout_rmse_nm/before",
             *after = "/paths/spring/heldout_rmse_nm/after";
  page.heading("Stiffness over the recordings");
  add_figure(page, over_recordings(summary, "", "stiffness (N·m/rad)", {{"", k, Hue::blue}}),
             "The linear stiffness of each recording's extended model.");
  page.heading("Errors over the recordings");
  add_figure(page,
             over_recordings(summary, "", "error on unseen blocks (N·m)",
                             {{"as given", given, Hue::vermilion},
                              {"same physics, refitted", before, Hue::ink},
                              {"with what was missing", after, Hue::blue}}),
             "Root mean square error of the spring's torque on blocks that no fit has seen.");
  add_worst(page, summary, "Where the extended model is worst", "Error (N·m)", after);
}

}  // namespace

HtmlReport page_of(const Summary& summary) {
  const bool evaluated = summary.command == "evaluate";
  const std::size_t all = summary.answers.size();
  const auto failed = std::size_t(
      std::ranges::count_if(summary.answers, [](const json& a) { return a.contains("why"); }));
  const std::string done = evaluated ? "evaluated" : "diagnosed";
  HtmlReport page(std::to_string(all) + (all == 1 ? " recording " : " recordings ") + done);
  page.verdict(failed == 0 ? "All " + std::to_string(all) + " were " + done + "."
                           : std::to_string(all - failed) + " of " + std::to_string(all) +
                                 " were " + done + "; " + std::to_string(failed) + " failed.");
  evaluated ? add_evaluations(page, summary) : add_diagnoses(page, summary);
  add_failed(page, summary);
  add_notes(page, summary);
  return page;
}

}  // namespace searig::app
