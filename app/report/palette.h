// The colours of every picture the program makes, on paper, in a browser and in a window.
#pragma once

#include <array>
#include <cstddef>

namespace searig::app {

/// Told apart with every common colour blindness (M. Okabe, K. Ito, "Color Universal Design",
/// 2008).
enum class Hue : std::size_t { ink, blue, vermilion, green, purple, orange, sky };

struct Shades {
  const char* name;
  const char* light;  ///< on a white ground
  const char* dark;   ///< on a dark ground
};

inline constexpr std::array<Shades, 7> hues{{
    {"ink", "#1f2328", "#e6e8eb"},
    {"blue", "#0072b2", "#5bb8f0"},
    {"vermilion", "#d55e00", "#ff8f4d"},
    {"green", "#009e73", "#3fd0a4"},
    {"purple", "#a8568a", "#e09cc6"},
    {"orange", "#b97d00", "#f0b429"},
    {"sky", "#3d94c8", "#8fd0f5"},
}};

inline constexpr Shades ground{"ground", "#ffffff", "#16191d"};
inline constexpr Shades grid{"grid", "#e3e6ea", "#31363d"};
inline constexpr Shades faint{"faint", "#5b636d", "#9aa4b0"};

constexpr const Shades& shades(Hue hue) {
  return hues[static_cast<std::size_t>(hue)];
}

}  // namespace searig::app
