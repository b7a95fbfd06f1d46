#include "acquisition/recording/toml_section.h"

#include <cmath>

#include "acquisition/error.h"
#include "acquisition/recording/text_file.h"

namespace searig::acquisition {

void Section::refuse(const toml::node* node, const std::string& what) const {
  const auto line = (node ? node->source() : table_.source()).begin.line;
  throw InputError(file_.string() + ", line " + std::to_string(line ? line : 1) + ": " + what +
                   ".");
}

std::optional<double> Section::number(std::string_view of) const {
  const toml::node* node = table_.get(of);
  if (!node) return std::nullopt;
  const auto value = node->value<double>();
  if (!value || !std::isfinite(*value)) refuse(node, key(of) + " must be a finite number");
  return value;
}

std::optional<double> Section::positive(std::string_view of) const {
  const auto value = number(of);
  if (value && *value <= 0.0) refuse(table_.get(of), key(of) + " must be positive");
  return value;
}

std::optional<double> Section::nonzero(std::string_view of) const {
  const auto value = number(of);
  if (value && *value == 0.0) refuse(table_.get(of), key(of) + " must not be zero");
  return value;
}

std::optional<std::string> Section::text(std::string_view of) const {
  const toml::node* node = table_.get(of);
  if (!node) return std::nullopt;
  const auto value = node->value_exact<std::string>();
  if (!value) refuse(node, key(of) + " must be a text");
  return value;
}

Section Section::section(std::string_view of) const {
  const toml::node* node = table_.get(of);
  const std::string path = name_.empty() ? std::string(of) : key(of);
  if (!node) refuse(node, "the section [" + path + "] is missing");
  if (!node->is_table()) refuse(node, path + " must be a table, not a value");
  return {file_, path, *node->as_table()};
}

toml::table parse_toml(const std::filesystem::path& file) {
  const std::string text = read_text_file(file);
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(file.string() + ", line " + std::to_string(error.source().begin.line) +
                     ", column " + std::to_string(error.source().begin.column) + ": " +
                     std::string(error.description()) + ".");
  }
}

}  // namespace searig::acquisition
