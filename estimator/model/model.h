// A simulation as a list of physical terms: what model.toml says.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace searig::estimator {

/// One physical term, named as in the catalogue ("spring.linear"), with its parameters in SI units
/// (the unit is part of each parameter's name).
struct Term {
  std::string effect;
  std::map<std::string, double> parameters;
};

/// The terms that a simulation has; a term that is absent is not simulated.
struct Model {
  std::vector<Term> terms;

  bool has(std::string_view effect) const { return find(effect) != nullptr; }
  const Term* find(std::string_view effect) const;
  Term* find(std::string_view effect);
  std::optional<double> get(std::string_view effect, std::string_view parameter) const;
  void set(std::string_view effect, std::string_view parameter, double value);
};

/// Reads the text of a model file; `name` is the file's name for error sentences.
/// Throws std::invalid_argument with one sentence that names file, line and term.
Model parse_model(std::string_view text, std::string_view name);

/// The text of a model file; parse_model(to_toml(m)) is m.
std::string to_toml(const Model& model);

}  // namespace searig::estimator
