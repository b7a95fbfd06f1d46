#include "tests/proving/score/truth.h"

#include <fstream>
#include <stdexcept>

namespace searig::proving {
namespace {

std::string stratum_from(const std::string& level, double rho) {
  if (level == "exact" || level == "numbers") return "null " + level;
  if (level == "strange") return "nameless";
  if (level == "rare") return "masked";
  if (level != "single") return level;
  return rho >= 3.0   ? "single strong"
         : rho >= 1.0 ? "single medium"
         : rho >= 0.3 ? "single weak"
                      : "single faint";
}

}  // namespace

std::map<std::string, Truth> read_truths(const std::filesystem::path& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("cannot read " + path.string());
  std::map<std::string, Truth> truths;
  const nlohmann::json all = nlohmann::json::parse(file);
  for (const auto& [name, sealed] : all.items()) {
    Truth t;
    t.sealed = sealed;
    t.level = sealed.at("level");
    t.rho = sealed.at("rho").is_number() ? sealed.at("rho").get<double>() : 0.0;
    t.stratum = sealed.value("stratum", stratum_from(t.level, t.rho));
    t.variant = sealed.value("variant", "");
    for (const auto& effect : sealed.at("effects")) t.families.insert(family(effect));
    truths[name] = t;
  }
  return truths;
}

}  // namespace searig::proving
