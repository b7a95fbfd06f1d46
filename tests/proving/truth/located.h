#pragma once

#include <string>
#include <vector>

#include "tests/proving/rig/rig.h"

namespace searig::proving {

/// Where the truth is local. Empty when it is everywhere.
struct Located {
  struct Region {
    std::string channel;
    double from, to;
  };
  std::vector<std::pair<double, double>> intervals_s;  ///< true seconds
  std::vector<double> instants_s;                      ///< nothing before, something after
  std::vector<Region> regions;
  bool empty() const { return intervals_s.empty() && instants_s.empty() && regions.empty(); }
};

/// variant: the masked item's regime, whose interval is part of the truth.
Located locate(const Rig& rig, const std::string& variant);

}  // namespace searig::proving
