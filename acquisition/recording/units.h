// Units that a column mapping may name, and the unit that each channel has inside.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace searig::acquisition {

/// si = factor * value + offset
struct UnitScale {
  double factor = 1.0;
  double offset = 0.0;
};

/// What a unit measures, written as its SI unit: "rad", "s", "N", "N*m", "A", "rad/s", "degC" or
/// "1".
struct Unit {
  std::string_view name;
  std::string_view measures;
  UnitScale to_si;
};

/// The unit of that name ("deg", "ms", "mNm", "kg" as a weight), or none.
std::optional<Unit> find_unit(std::string_view name);

/// The SI unit of a channel ("deflection_rad" -> "rad"), or none where there is no such channel.
std::optional<std::string_view> channel_unit(std::string_view channel);

/// The unit that a channel's name ends with ("effort_nm" -> "N*m"), known or not; "1" where there
/// is none.
std::string_view unit_of(std::string_view channel);

/// The units that measure the same, for an error sentence: "rad, mrad, deg".
std::string units_like(std::string_view si_unit);

}  // namespace searig::acquisition
