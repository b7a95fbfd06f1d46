// A batch's page of diagnoses: what was found, by kind, and the curves.
#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "app/batch/page_parts.h"
#include "app/report/diagnosis_words.h"
#include "app/report/quantity.h"

namespace searig::app {
namespace {

using nlohmann::json;

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
  add_counted(page, "Verdicts", "Verdict", verdicts);
  std::vector<std::vector<std::string>> rows;
  for (auto& [effect, sure] : found) {
    std::ranges::sort(sure);
    rows.push_back(
        {effect, title_of(effect), std::to_string(sure.size()), figures(quantile(sure, 0.5), 2)});
  }
  page.heading("Findings by kind");
  if (rows.empty()) page.paragraph("No physics was found missing.");
  if (!rows.empty()) page.table({"Effect", "What", "Recordings", "Middle probability"}, rows);
  add_counted(page, "What the recordings cannot decide", "Effect", open);
}

}  // namespace

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

}  // namespace searig::app
