#include "estimator/model/model.h"

#include <toml++/toml.h>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "estimator/physics/catalogue.h"

namespace searig::estimator {
namespace {

[[noreturn]] void refuse(std::string_view name, const toml::node& node, const std::string& what) {
  throw std::invalid_argument(std::string(name) + ": line " +
                              std::to_string(node.source().begin.line) + ": " + what);
}

std::string shortest(double value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  std::string out(text, end);
  if (out.find_first_of(".en") == std::string::npos) out += ".0";  // TOML tells 1 from 1.0
  return out;
}

Term parse_term(const std::string& effect, const toml::table& table, std::string_view file) {
  const Effect* known = find_effect(effect);
  if (!known) refuse(file, table, "no effect is called [" + effect + "]");
  Term term{effect, {}};
  for (const auto& [key, node] : table) {
    const std::string parameter(key.str());
    const auto value = node.value<double>();
    if (!value || !std::isfinite(*value))
      refuse(file, node, "[" + effect + "] " + parameter + " must be a finite number");
    const auto p = std::ranges::find(known->parameters(), parameter, &Parameter::name);
    if (p == known->parameters().end())
      refuse(file, node, "[" + effect + "] has no parameter " + parameter);
    if (*value < p->lower || *value > p->upper)
      refuse(file, node,
             "[" + effect + "] " + parameter + " = " + shortest(*value) + " is outside " +
                 shortest(p->lower) + " to " + shortest(p->upper));
    term.parameters[parameter] = *value;
  }
  for (const auto& p : known->parameters())
    if (!p.fallback && !term.parameters.contains(p.name))
      refuse(file, table, "[" + effect + "] lacks " + p.name);
  if (const auto complaint = known->complaint(term); !complaint.empty())
    refuse(file, table, "[" + effect + "] " + complaint);
  return term;
}

}  // namespace

const Term* Model::find(std::string_view effect) const {
  const auto it = std::ranges::find(terms, effect, &Term::effect);
  return it == terms.end() ? nullptr : &*it;
}

Term* Model::find(std::string_view effect) {
  return const_cast<Term*>(std::as_const(*this).find(effect));
}

std::optional<double> Model::get(std::string_view effect, std::string_view parameter) const {
  const Term* term = find(effect);
  if (!term) return std::nullopt;
  const auto it = term->parameters.find(std::string(parameter));
  if (it == term->parameters.end()) return std::nullopt;
  return it->second;
}

void Model::set(std::string_view effect, std::string_view parameter, double value) {
  Term* term = find(effect);
  if (!term) term = &terms.emplace_back(Term{std::string(effect), {}});
  term->parameters[std::string(parameter)] = value;
}

Model parse_model(std::string_view text, std::string_view name) {
  toml::table root;
  try {
    root = toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    throw std::invalid_argument(std::string(name) + ": line " +
                                std::to_string(error.source().begin.line) + ": " +
                                std::string(error.description()));
  }
  if (root["format"].value_or(std::string()) != "searig-model/1")
    throw std::invalid_argument(std::string(name) + ": format must be \"searig-model/1\"");
  Model model;
  for (const auto& [group, node] : root) {
    if (group == "format") continue;
    const auto* effects = node.as_table();
    if (!effects) refuse(name, node, std::string(group.str()) + " is not a group of effects");
    for (const auto& [effect, term] : *effects) {
      const std::string full = std::string(group.str()) + "." + std::string(effect.str());
      if (!term.is_table()) refuse(name, term, full + " is not a table of parameters");
      model.terms.push_back(parse_term(full, *term.as_table(), name));
    }
  }
  return model;
}

std::string to_toml(const Model& model) {
  std::string out = "format = \"searig-model/1\"\n";
  for (const auto& term : model.terms) {
    out += "\n[" + term.effect + "]\n";
    for (const auto& [parameter, value] : term.parameters)
      out += parameter + " = " + shortest(value) + "\n";
  }
  return out;
}

}  // namespace searig::estimator
