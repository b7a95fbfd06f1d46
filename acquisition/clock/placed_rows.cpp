#include "acquisition/clock/placed_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace searig::acquisition {

PlacedRows place_rows(const Stream& stream, const std::vector<RunMap>& runs) {
  const std::vector<double> t_s = on_module_clock(stream, runs);
  std::vector<std::size_t> order(t_s.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t row) { return std::isnan(t_s[row]); });
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return t_s[a] < t_s[b]; });
  PlacedRows placed;
  for (const std::size_t row : order) {
    if (!placed.t_s.empty() && t_s[row] == placed.t_s.back()) continue;
    placed.rows.push_back(row);
    placed.t_s.push_back(t_s[row]);
  }
  return placed;
}

std::vector<double> at_rows(const std::vector<double>& channel, const PlacedRows& placed) {
  std::vector<double> values;
  if (channel.empty()) return values;
  values.reserve(placed.rows.size());
  for (const std::size_t row : placed.rows) values.push_back(channel[row]);
  return values;
}

}  // namespace searig::acquisition
