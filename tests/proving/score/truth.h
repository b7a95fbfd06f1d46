#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace searig::proving {

/// rig.delay and rig.lag count as one name: what tells them apart lies above the load cell's band.
inline std::string family(const std::string& effect) {
  return effect == "rig.delay" || effect == "rig.lag" ? "rig.late" : effect;
}

/// What answers.json says about one recording. Practice answers have no stratum: it follows from
/// their level and rho.
struct Truth {
  std::string stratum, level, variant;
  std::set<std::string> families;
  double rho = 0.0;
  nlohmann::json sealed;

  bool is_null() const { return level == "exact" || level == "numbers"; }
  bool is_nameless() const { return level == "strange"; }
};

std::map<std::string, Truth> read_truths(const std::filesystem::path& answers_json);

}  // namespace searig::proving
