#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace searig::proving {

enum class Strength { none, faint, weak, medium, strong, obvious };

/// One recording to be made, before anything is drawn for it.
struct Item {
  std::string name;                  ///< p0001...: says nothing
  std::string stratum;               ///< as in the README's table
  std::string level;                 ///< as in the practice answers
  std::string variant;               ///< what is special about it, within its stratum
  std::vector<std::string> effects;  ///< contract names, or the form of a nameless one
  Strength strength = Strength::none;
  std::uint64_t seed = 0;
};

/// The whole proving ground for this seed, shuffled, so that a name betrays nothing.
std::vector<Item> plan_full(std::uint64_t seed);

/// "full", "small" (a share of every stratum), or one stratum; at most count when count > 0.
std::vector<Item> plan_set(const std::string& set, std::uint64_t seed, int count);

}  // namespace searig::proving
