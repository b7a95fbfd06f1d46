// A line of any number of points, as what it covers of each pixel column.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "app/report/plot.h"

namespace searig::app {

/// The lowest and highest of any stretch of a column that grows, without a look at all of it: they
/// are kept of every 16 values, of every 64, of every 256 and so on.
class Extremes {
 public:
  static constexpr std::size_t block = 16;  ///< values in the smallest

  /// Takes up what the column has grown by; what was there has to have stayed.
  void follow(const std::vector<double>& y);
  /// Begins anew.
  void clear();

  /// Of places [first, last), which is not empty and has been followed; NaN where a value is not
  /// finite.
  Range in(const std::vector<double>& y, std::size_t first, std::size_t last) const;

 private:
  static constexpr std::size_t fan = 4, levels = 10;
  std::array<std::vector<Range>, levels> blocks_;  ///< [0]: of 16 values each, [1]: of 64, ...
};

enum class Joined { no, yes };

/// Of each of `columns` pixel columns that share x from `view.low` to `view.high` evenly: the range
/// of y over which it is covered, by the points and, if they are joined, by the straight lines
/// between them; low > high where it is not. x rises; a point that is not finite breaks the line.
/// extremes: of all of y. Columns of more than 256 points begin within a sixteenth of a column of
/// where they should. The time does not grow with the number of points. Writes to `spans`.
void column_spans(const std::vector<double>& x, const std::vector<double>& y,
                  const Extremes& extremes, Range view, std::size_t columns, Joined joined,
                  std::vector<Range>& spans);

}  // namespace searig::app
