#include "app/rig/weighing.h"

namespace searig::app {

std::optional<acquisition::KnownWeight> Weighing::take(const std::vector<double>& counts) {
  for (const double reading : counts) {
    if (taken_ == first + enough) break;
    if (++taken_ > first) sum_ += reading;
  }
  if (taken_ < first + enough) return std::nullopt;
  return acquisition::KnownWeight{force_n_, sum_ / double(enough)};
}

}  // namespace searig::app
