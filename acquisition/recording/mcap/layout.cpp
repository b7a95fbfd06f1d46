#include "acquisition/recording/mcap/layout.h"

#include <cmath>

namespace searig::acquisition::mcap {
namespace {

constexpr std::string_view type = "float64 ";

}  // namespace

std::string row_definition(const std::vector<std::string>& columns) {
  std::string definition;
  for (const std::string& column : columns) definition.append(type).append(column).append("\n");
  return definition;
}

std::vector<std::string> row_columns(std::string_view definition) {
  std::vector<std::string> columns;
  while (!definition.empty()) {
    const std::size_t end = definition.find('\n');
    if (end == std::string_view::npos || !definition.starts_with(type)) return {};
    columns.emplace_back(definition.substr(type.size(), end - type.size()));
    definition.remove_prefix(end + 1);
  }
  return columns;
}

std::uint64_t nanoseconds(double seconds) {
  constexpr double most = 1.8e19;  // uint64 ends just above, in the year 2540
  const double ns = std::round(seconds * 1e9);
  return ns > 0.0 ? static_cast<std::uint64_t>(std::fmin(ns, most)) : 0;
}

}  // namespace searig::acquisition::mcap
