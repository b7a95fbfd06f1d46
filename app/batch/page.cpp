// A batch on one page: the curves first, then what was found, by kind, and what failed.
#include <algorithm>
#include <cctype>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/batch/page_parts.h"
#include "app/batch/summary.h"

namespace searig::app {
namespace {

using nlohmann::json;

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

void add_notes(HtmlReport& page, const Summary& summary) {
  std::map<std::string, std::size_t> counts;
  for (const json& answer : summary.answers) {
    std::set<std::string> here;  // a recording may have several of one kind
    for (const json& note : answer.value("notes", json::array())) here.insert(kind_of(note));
    for (const std::string& kind : here) ++counts[kind];
  }
  add_counted(page, "Notes by kind", "Note", counts);
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
  page.table({"Recording", "Why"}, rows, only_first(failed));
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
