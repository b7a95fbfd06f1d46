#include "tests/proving/score/score.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>

#include "tests/proving/score/table.h"

namespace searig::proving {
namespace {

std::string joined(const std::set<std::string>& names) {
  std::string all;
  for (const auto& n : names) all += (all.empty() ? "" : "+") + n;
  return all;
}

void print_line(const std::string& name, const Truth& t, const Judgement& j, std::ostream& out) {
  char line[400];
  std::snprintf(line, sizeof line, "%s %s %-13s %-18s %-52.52s rho %6.2f -> %s%s %s\n",
                j.right() ? "ok" : "--", name.c_str(), t.stratum.c_str(), t.variant.c_str(),
                joined(t.families).c_str(), t.rho, joined(j.found).c_str(),
                j.unexplained ? " unexplained" : "", j.error.c_str());
  out << line;
}

Runs obtain(const ScoreOptions& o, const std::vector<std::string>& names) {
  if (o.load_results.empty()) return run_all(o.tool, o.directory / "recordings", names, o.jobs);
  std::ifstream file(o.load_results);
  if (!file) throw std::runtime_error("cannot read " + o.load_results.string());
  return runs_from(nlohmann::json::parse(file));
}

}  // namespace

nlohmann::json score(const ScoreOptions& o, std::ostream& out) {
  auto truths = read_truths(o.directory / "answers.json");
  std::erase_if(truths, [&](const auto& t) {
    return !o.only.empty() && t.second.stratum != o.only && !t.first.starts_with(o.only);
  });
  std::vector<std::string> names;
  for (const auto& [name, t] : truths) names.push_back(name);
  const Runs runs = obtain(o, names);
  Judgements all;
  for (const auto& [name, truth] : truths) {
    const auto run = runs.find(name);
    const Run none{nullptr, "no result", 0.0};
    all[name] =
        judge(truth, run == runs.end() ? none : run->second, o.directory / "recordings" / name);
    if (o.verbose || !all[name].right()) print_line(name, truth, all[name], out);
  }
  out << '\n';
  print_table(all, out);
  out << '\n';
  nlohmann::json summary;
  summary["reliability"] = print_reliability(all, out);
  out << '\n';
  summary["targets"] = print_targets(all, out);
  if (!o.save_results.empty())
    std::ofstream(o.save_results)
        << nlohmann::json{{"results", to_json(runs)}, {"summary", summary}}.dump(1) << '\n';
  return summary;
}

}  // namespace searig::proving
