// The lowest and highest of any stretch of a column that grows, without a look at all of it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace searig::app {

/// Of every 16 values, of every 256, of every 4096 and so on the places of the lowest and the
/// highest are kept: a stretch of 600,000 values is told from about a hundred of them.
class Extremes {
 public:
  struct Found {
    std::size_t lowest, highest;  ///< places in the column
    bool whole;                   ///< every value is finite; else the places mean nothing
  };

  /// Takes up what the column has grown by; what was there has to have stayed.
  void follow(const std::vector<double>& y);
  /// Begins anew.
  void clear();

  /// Of places [first, last), which is not empty and within what was followed.
  Found in(const std::vector<double>& y, std::size_t first, std::size_t last) const;

 private:
  static constexpr std::size_t fan = 16, levels = 6;
  std::array<std::vector<Found>, levels> blocks_;  ///< [0]: of 16 values each, [1]: of 256, ...
};

}  // namespace searig::app
