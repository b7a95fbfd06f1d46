#include "app/report/quantity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/report/axis.h"

namespace searig::app {
namespace {

struct Suffix {
  std::string_view ending, unit;
};

/// Longer endings first: "_rad_s" must not be taken for "_s".
constexpr std::array<Suffix, 17> suffixes{{
    {"_nm_s_per_rad", "N·m·s/rad"},
    {"_nm_per_rad3", "N·m/rad³"},
    {"_nm_per_rad", "N·m/rad"},
    {"_nm_per_a", "N·m/A"},
    {"_per_rad", "rad/rad"},
    {"_nm_per_min", "N·m/min"},
    {"_rad_s2", "rad/s²"},
    {"_rad_s", "rad/s"},
    {"_kg_m2", "kg·m²"},
    {"_rad2", "rad²"},
    {"_rad", "rad"},
    {"_nm", "N·m"},
    {"_hz", "Hz"},
    {"_a", "A"},
    {"_c", "°C"},
    {"_s", "s"},
    {"_j", "J"},
}};

/// Names that are nothing but a unit, or whose ending is none.
constexpr std::array<std::array<std::string_view, 3>, 3> whole{{
    {"per_c", "change per degree", "1/°C"},
    {"nm_per_min", "drift", "N·m/min"},
    {"cycles_per_rad", "cycles", "rad/rad"},
}};

std::string spaced(std::string_view name) {
  std::string out(name);
  std::ranges::replace(out, '_', ' ');
  return out;
}

}  // namespace

Quantity quantity_of(std::string_view name) {
  for (const auto& [known, words, unit] : whole) {
    if (name == known) return {std::string(words), std::string(unit)};
  }
  for (const auto& [ending, unit] : suffixes) {
    if (name.size() > ending.size() && name.ends_with(ending)) {
      return {spaced(name.substr(0, name.size() - ending.size())), std::string(unit)};
    }
  }
  return {spaced(name), ""};
}

std::string label_of(std::string_view name) {
  const Quantity q = quantity_of(name);
  return q.unit.empty() ? q.name : q.name + " (" + q.unit + ")";
}

std::string figures(double value, int significant) {
  if (!std::isfinite(value)) return "–";
  if (value == 0.0) return "0";
  // Rounded first: 0.09996 has its first digit at 0.1.
  char rounded[64];
  std::snprintf(rounded, sizeof rounded, "%.*e", significant - 1, std::abs(value));
  const int exponent =
      std::atoi(std::string(rounded).substr(std::string(rounded).find('e') + 1).c_str());
  if (exponent >= -4 && exponent < 6) return number(value, std::max(0, significant - 1 - exponent));
  return number(value / std::pow(10.0, exponent), significant - 1) + "e" + std::to_string(exponent);
}

Rounded rounded(double value, double lower, double upper) {
  const double half = 0.5 * (upper - lower);
  if (!(half > 0) || !std::isfinite(half)) return {figures(value), figures(lower), figures(upper)};
  // Two digits of the half width, and never fewer than two of the value.
  const int last = static_cast<int>(std::floor(std::log10(half))) - 1;
  const auto digits = [last](double x) {
    const int first = x == 0.0 ? last : static_cast<int>(std::floor(std::log10(std::abs(x))));
    return std::clamp(first - last + 1, 2, 7);
  };
  return {figures(value, digits(value)), figures(lower, digits(lower)),
          figures(upper, digits(upper))};
}

std::string with_unit(double value, std::string_view unit, int significant) {
  const std::string text = figures(value, significant);
  return unit.empty() ? text : text + " " + std::string(unit);
}

std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') text[0] = char(text[0] - 'a' + 'A');
  return text;
}

}  // namespace searig::app
