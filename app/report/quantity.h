// Names that carry their unit ("c_nm_s_per_rad") as people write them ("c", "N·m·s/rad").
#pragma once

#include <string>
#include <string_view>

namespace searig::app {

struct Quantity {
  std::string name;  ///< in words: "deflection rate"
  std::string unit;  ///< empty for a pure number
};

Quantity quantity_of(std::string_view name_with_unit);

/// "deflection rate (rad/s)", the label of an axis.
std::string label_of(std::string_view name_with_unit);

/// A number with so many significant digits, without an exponent where that stays short.
std::string figures(double value, int significant = 3);

/// A measured number with as many digits as its interval deserves, and the interval's ends.
struct Rounded {
  std::string value, lower, upper;
};
Rounded rounded(double value, double lower, double upper);

/// "0.045 N·m".
std::string with_unit(double value, std::string_view unit, int significant = 3);

/// The text with a capital letter at its front.
std::string capital(std::string text);

}  // namespace searig::app
