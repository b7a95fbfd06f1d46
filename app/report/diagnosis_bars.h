// Two small pictures of numbers: how likely each explanation is, and how well each parameter is
// known.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace searig::app {

struct Bar {
  std::string name;
  double share = 0.0;  ///< 0 to 1
  bool chosen = false;
};

/// One bar for each explanation, with its probability written out.
std::string probability_bars(const std::string& title, const std::vector<Bar>& bars,
                             int width = 900);

/// A parameter with its interval, and what the model gave where it gave something.
struct Known {
  std::string name;
  double value = 0.0, lower = 0.0, upper = 0.0;
  std::optional<double> given = {};
};

/// Intervals relative to the value, in percent, so that all parameters share one axis. Parameters
/// whose interval holds zero are left out: they have no size to compare with. Empty where none is
/// left.
std::string interval_plot(const std::string& title, const std::vector<Known>& parameters,
                          int width = 900);

}  // namespace searig::app
