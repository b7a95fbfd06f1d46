#include "tests/proving/score/parameters.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace searig::proving {
namespace {

using nlohmann::json;
using Conversion = std::function<double(double)>;

const json& list(const json& object, const char* key) {
  static const json none = json::array();
  return object.is_object() && object.contains(key) && object[key].is_array() ? object[key] : none;
}

std::optional<double> value_of(const json& finding, const std::string& name) {
  for (const auto& p : list(finding, "parameters"))
    if (p.value("name", "") == name && p.contains("value") && p["value"].is_number())
      return p["value"].get<double>();
  return {};
}

bool comparable(const Truth& truth, const std::string& key) {
  if (!truth.sealed.contains("comparable")) return true;  // practice: every number is
  const json& names = list(truth.sealed, "comparable");
  return std::find(names.begin(), names.end(), key) != names.end();
}

/// One physics, two ways to write it: another reference temperature, or a wave upside down.
Conversion to_our_convention(const Truth& truth, const json& finding, const std::string& name) {
  const std::string effect = finding.value("effect", "");
  const json& numbers = truth.sealed.at("truth");
  if (name == "per_c" && numbers.contains(effect + ".reference_c")) {
    const double ours = numbers[effect + ".reference_c"];
    const double theirs = value_of(finding, "reference_c").value_or(ours);
    return [=](double per_c) { return per_c / (1.0 + per_c * (ours - theirs)); };
  }
  const bool wave = name == "torque_nm" && value_of(finding, "phase_rad").has_value();
  if (wave && value_of(finding, name).value_or(0.0) < 0.0) return [](double a) { return -a; };
  return [](double same) { return same; };
}

}  // namespace

std::vector<Parameter> judge_parameters(const Truth& truth, const json& finding) {
  std::vector<Parameter> out;
  const std::string effect = finding.value("effect", "");
  const json& numbers = truth.sealed.at("truth");
  for (const auto& p : list(finding, "parameters")) {
    const std::string name = p.value("name", ""), key = effect + "." + name;
    const auto said = value_of(finding, name);
    if (!said || !numbers.contains(key) || !comparable(truth, key)) continue;
    if (name == "phase_rad" || name == "reference_c") continue;  // where a wave starts is no size
    const double is = numbers[key];
    const Conversion ours = to_our_convention(truth, finding, name);
    Parameter judged{key, std::abs(ours(*said) - is) / std::max(std::abs(is), 1e-12), {}};
    if (const json& ci = list(p, "ci95");
        ci.size() == 2 && ci[0].is_number() && ci[1].is_number()) {
      const auto [low, high] = std::minmax({ours(ci[0].get<double>()), ours(ci[1].get<double>())});
      judged.covered = low <= is && is <= high;
    }
    out.push_back(judged);
  }
  return out;
}

}  // namespace searig::proving
