#include "app/report/axis.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace searig::app {
namespace {

double round_step(double rough) {
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (rough <= factor * power * (1.0 + 1e-9)) return factor * power;
  }
  return 10.0 * power;
}

/// Neither empty nor so narrow that the ticks fall together in double precision.
Range usable(Range range) {
  if (!std::isfinite(range.low) || !std::isfinite(range.high)) return {0.0, 1.0};
  if (range.high < range.low) std::swap(range.low, range.high);
  const double size = std::max(std::abs(range.low), std::abs(range.high));
  const double least = size > 0.0 ? 1e-9 * size : 1e-12;
  if (range.high - range.low >= least) return range;
  const double half = size > 0.0 ? 0.05 * size : 0.5;
  return {range.low - half, range.high + half};
}

}  // namespace

std::string number(double value, int decimals) {
  if (!std::isfinite(value)) return "–";
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", std::max(0, decimals), std::abs(value));
  const bool is_zero = std::string(text).find_first_not_of("0.") == std::string::npos;
  return (value < 0.0 && !is_zero ? "\u2212" : "") + std::string(text);
}

Axis make_axis(Range range, int wanted) {
  Axis axis;
  axis.range = usable(range);
  const double step =
      round_step((axis.range.high - axis.range.low) / static_cast<double>(std::max(1, wanted)));
  const double size = std::max(std::abs(axis.range.low), std::abs(axis.range.high));
  if (size >= 1e5 || size < 1e-3) axis.exponent = static_cast<int>(std::floor(std::log10(size)));
  axis.decimals =
      std::max(0, axis.exponent - static_cast<int>(std::floor(std::log10(step) + 1e-9)));
  const double slack = 1e-9 * step;
  for (double i = std::ceil((axis.range.low - slack) / step); i * step <= axis.range.high + slack;
       i += 1.0) {
    axis.ticks.push_back(i * step);
  }
  return axis;
}

std::string Axis::label(double tick) const {
  return number(tick / std::pow(10.0, exponent), decimals);
}

Range span_of(const std::vector<const std::vector<double>*>& values, double margin) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const auto* column : values) {
    for (const double value : *column) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  }
  if (low > high) return {0.0, 1.0};
  const double extra = margin * (high - low);
  return usable({low - extra, high + extra});
}

}  // namespace searig::app
