#pragma once

#include <map>
#include <string>
#include <vector>

namespace searig::proving {

/// One piece of physics in the true rig that its owner does not simulate.
struct Effect {
  std::string name;  ///< of the contract, or "no name: ..."
  std::string form;  ///< the mathematical form that the rig really has
  std::map<std::string, double> parameters;
  std::vector<std::string> amplitude;   ///< parameters that scale with its strength
  std::vector<std::string> comparable;  ///< parameters that mean the same in the contract

  double at(const std::string& key) const { return parameters.at(key); }
  double at_or(const std::string& key, double otherwise) const {
    const auto found = parameters.find(key);
    return found == parameters.end() ? otherwise : found->second;
  }
  void scale(double factor) {
    for (const auto& key : amplitude) parameters[key] *= factor;
  }
};

/// Terms that every true rig has: to conceal one, its owner's model lacks it.
inline bool is_baseline_term(const std::string& name) {
  return name == "drive.coulomb" || name == "drive.viscous" || name == "drive.inertia";
}

inline bool is_nameless(const Effect& effect) {
  return effect.name.rfind("no name", 0) == 0;
}

}  // namespace searig::proving
