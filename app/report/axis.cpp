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

std::vector<double> ticks_of(const Range& range, double step) {
  std::vector<double> ticks;
  const double slack = 1e-9 * step;  // a tick at the very end is not lost to rounding
  const double end = range.high + slack;
  for (double i = std::ceil((range.low - slack) / step); i * step <= end; i += 1.0) {
    ticks.push_back(i * step);
  }
  return ticks;
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
  const double span = axis.range.high - axis.range.low;
  double step = round_step(span / std::max(1, wanted));
  axis.ticks = ticks_of(axis.range, step);
  // One tick alone says nothing about the scale.
  for (int more = wanted + 1; axis.ticks.size() < 3 && more < wanted + 8; ++more) {
    step = round_step(span / more);
    axis.ticks = ticks_of(axis.range, step);
  }
  const double size = std::max(std::abs(axis.range.low), std::abs(axis.range.high));
  if (size >= 1e5 || size < 1e-3) axis.exponent = static_cast<int>(std::floor(std::log10(size)));
  const auto last_digit = static_cast<int>(std::floor(std::log10(step) + 1e-9));
  axis.decimals = std::max(0, axis.exponent - last_digit);
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
