#include "tests/proving/score/judge.h"

#include <algorithm>
#include <cmath>

#include "tests/proving/score/overlap.h"

namespace searig::proving {
namespace {

using nlohmann::json;
constexpr double confident = 0.7;

const json& list(const json& object, const char* key) {
  static const json none = json::array();
  return object.is_object() && object.contains(key) && object[key].is_array() ? object[key] : none;
}

double number(const json& object, const char* key, double otherwise) {
  return object.is_object() && object.contains(key) && object[key].is_number()
             ? object[key].get<double>()
             : otherwise;
}

void judge_names(const Truth& truth, const json& answer, Judgement& j) {
  std::set<std::string> sure;
  for (const auto& f : list(answer, "findings")) {
    const std::string name = family(f.value("effect", ""));
    const double p = number(f, "probability", 0.0);
    j.found.insert(name), j.mentioned.insert(name);
    if (p > confident) sure.insert(name);
    j.asserted.push_back({p, truth.families.contains(name)});
    for (const auto& a : list(f, "alternatives")) j.mentioned.insert(family(a.value("effect", "")));
  }
  for (const auto& u : list(answer, "undecidable"))
    for (const auto& e : list(u, "effects")) j.mentioned.insert(family(e.get<std::string>()));
  for (const auto& name : j.found)
    (truth.families.contains(name) ? j.true_positives : j.false_positives)++;
  j.false_negatives = static_cast<int>(truth.families.size()) - j.true_positives;
  j.verdict = answer.value("verdict", "");
  j.unexplained = j.verdict == "unexplained" ||
                  (answer.contains("unexplained") && !answer["unexplained"].is_null());
  j.wrong = std::any_of(sure.begin(), sure.end(),
                        [&](const auto& n) { return !truth.families.contains(n); });
  j.named = !truth.families.empty() && j.found == truth.families;
  j.contains = std::any_of(truth.families.begin(), truth.families.end(),
                           [&](const auto& n) { return j.mentioned.contains(n); });
  j.silent = j.found.empty() && !j.unexplained;
  j.alarm = truth.is_null() && !j.silent;
  j.misnamed = truth.is_nameless() && !sure.empty() && !j.unexplained;
}

void judge_numbers(const Truth& truth, const json& answer, Judgement& j) {
  for (const auto& f : list(answer, "findings")) {
    if (!truth.families.contains(family(f.value("effect", "")))) continue;
    const auto numbers = judge_parameters(truth, f);
    j.parameters.insert(j.parameters.end(), numbers.begin(), numbers.end());
  }
}

void judge_place(const Truth& truth, const json& answer, const std::filesystem::path& recording,
                 Judgement& j) {
  const json located = truth.sealed.value("located", json::object());
  j.local = !located.empty();
  if (!j.local) return;
  std::vector<json> places;
  if (answer.contains("unexplained")) places.push_back(answer["unexplained"]);
  for (const auto& f : list(answer, "findings"))
    if (truth.is_nameless() || truth.families.contains(family(f.value("effect", ""))))
      places.push_back(f.value("located", json()));
  for (const auto& place : places)
    if (const auto o = overlap(located, place, recording))
      j.overlap = std::max(j.overlap.value_or(0.0), *o);
}

void judge_heldout(const Truth& truth, const json& answer, Judgement& j) {
  if (truth.level != "single" || truth.rho < 0.3) return;
  for (const char* path : {"spring", "drive"}) {
    const json& reachable = truth.sealed.at("reachable_rmse_nm").at(path);
    const double before = number(reachable, "before", 0.0), after = number(reachable, "after", 0.0);
    const json paths = answer.value("paths", json::object());
    if (!paths.is_object() || !paths.contains(path) || !paths[path].is_object()) continue;
    const double reached =
        number(paths[path].value("heldout_rmse_nm", json::object()), "after", 0.0);
    if (reached > 0.0 && before > 1.05 * after) j.heldout_over_reachable.push_back(reached / after);
  }
}

}  // namespace

bool Judgement::right() const {
  if (failed) return false;
  if (stratum.starts_with("null")) return !alarm;
  if (stratum == "nameless") return unexplained;
  return named;
}

Judgement judge(const Truth& truth, const Run& run, const std::filesystem::path& recording) {
  Judgement j;
  j.stratum = truth.stratum;
  j.seconds = run.seconds;
  j.error = run.error;
  j.failed = !run.error.empty() || !run.answer.is_object();
  const json answer = j.failed ? json::object() : run.answer;
  judge_names(truth, answer, j);
  judge_numbers(truth, answer, j);
  judge_place(truth, answer, recording, j);
  judge_heldout(truth, answer, j);
  return j;
}

}  // namespace searig::proving
