#include "app/report/decimate.h"

#include <algorithm>
#include <cmath>

#include "app/report/extremes.h"

namespace searig::app {
namespace {

/// The points that stand for all points of one pixel column, in their order.
void write(std::size_t first, std::size_t lowest, std::size_t highest, std::size_t last,
           std::vector<std::size_t>& out) {
  const auto [a, b] = std::minmax(lowest, highest);
  for (const std::size_t i : {first, a, b, last})
    if (out.empty() || out.back() != i) out.push_back(i);
}

/// A column whose points are looked at one by one; those that are not finite cut it.
void scan(const std::vector<double>& y, std::size_t begin, std::size_t end,
          std::vector<std::size_t>& out) {
  for (std::size_t i = begin; i < end;) {
    if (!std::isfinite(y[i])) {
      if (!out.empty() && std::isfinite(y[out.back()])) out.push_back(i);  // breaks the line once
      ++i;
      continue;
    }
    const std::size_t first = i;
    std::size_t lowest = i, highest = i;
    for (; i < end && std::isfinite(y[i]); ++i) {
      if (y[i] < y[lowest]) lowest = i;
      if (y[i] > y[highest]) highest = i;
    }
    write(first, lowest, highest, i - 1, out);
  }
}

/// The first place behind `from` with x >= edge; looked for in growing steps, as it is near.
std::size_t behind(const std::vector<double>& x, std::size_t from, std::size_t end, double edge) {
  std::size_t step = 1;
  while (from + step < end && x[from + step] < edge) step *= 2;
  const auto begin = x.begin();
  return static_cast<std::size_t>(
      std::lower_bound(begin + static_cast<std::ptrdiff_t>(from + step / 2),
                       begin + static_cast<std::ptrdiff_t>(std::min(end, from + step)), edge) -
      begin);
}

}  // namespace

std::vector<std::size_t> decimate(const std::vector<double>& x, const std::vector<double>& y,
                                  double low, double high, std::size_t columns,
                                  const Extremes* extremes) {
  std::vector<std::size_t> out;
  const std::size_t size = std::min(x.size(), y.size());
  if (size == 0 || columns == 0 || !(high > low)) return out;
  const auto stop = x.begin() + static_cast<std::ptrdiff_t>(size);
  const auto begin_at = std::lower_bound(x.begin(), stop, low) - x.begin();
  const auto end_at = std::upper_bound(x.begin() + begin_at, stop, high) - x.begin();
  const std::size_t begin = begin_at > 0 ? static_cast<std::size_t>(begin_at) - 1 : 0;
  const std::size_t end = std::min(size, static_cast<std::size_t>(end_at) + 1);

  const double per_column = (high - low) / static_cast<double>(columns);
  for (std::size_t i = begin; i < end;) {
    const double edge = low + per_column * (std::floor((x[i] - low) / per_column) + 1.0);
    const std::size_t next = std::max(i + 1, behind(x, i, end, edge));
    const bool many = extremes != nullptr && next - i > 64;
    if (const auto found = many ? extremes->in(y, i, next) : Extremes::Found{0, 0, false};
        found.whole)
      write(i, found.lowest, found.highest, next - 1, out);
    else
      scan(y, i, next, out);
    i = next;
  }
  return out;
}

}  // namespace searig::app
