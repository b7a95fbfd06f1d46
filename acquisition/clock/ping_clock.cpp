#include "acquisition/clock/ping_clock.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arduino/firmware/payloads.h"

namespace searig::acquisition {
namespace {

constexpr double kWhile = 0.5;        // s, of whose arrivals the best one is kept
constexpr double kSlopeSure = 1e-11;  // of 1: far below what any clock keeps

struct Range {
  double low, high;
};

/// Where a function that rises and then falls is highest, by golden section.
template <typename Function>
double highest(Range range, Function function) {
  constexpr double ratio = 0.6180339887498949;
  double a = range.high - ratio * (range.high - range.low);
  double b = range.low + ratio * (range.high - range.low);
  double at_a = function(a), at_b = function(b);
  while (range.high - range.low > kSlopeSure) {
    if (at_a < at_b) {
      range.low = a, a = b, at_a = at_b;
      b = range.low + ratio * (range.high - range.low), at_b = function(b);
    } else {
      range.high = b, b = a, at_b = at_a;
      a = range.high - ratio * (range.high - range.low), at_a = function(a);
    }
  }
  return 0.5 * (range.low + range.high);
}

/// Where a function ends being at least 0, between a place where it is and an end of the range.
template <typename Function>
double last_at_least_zero(double inside, double end, Function function) {
  if (function(end) >= 0.0) return end;
  while (std::abs(end - inside) > kSlopeSure) {
    const double middle = 0.5 * (inside + end);
    (function(middle) >= 0.0 ? inside : end) = middle;
  }
  return inside;
}

}  // namespace

double least_ping_wire_s(unsigned baud) {
  return least_wire_s(wire::kHeaderSize + wire::PingPayload::kSize + wire::kCrcSize + 2, baud);
}

void PingClock::take(const Exchange& exchange) {
  from_below_.push_back(
      {exchange.device_received_s,
       exchange.host_sent_s - exchange.device_received_s + options_.least_there_s});
  from_above_.push_back({exchange.device_sent_s, exchange.host_received_s - exchange.device_sent_s -
                                                     options_.least_back_s});
  best_until_s_ = 0.0;
  forget(exchange.device_sent_s);
}

void PingClock::take_arrival(double device_sent_s, double host_s, double least_s) {
  const Bound bound{device_sent_s, host_s - device_sent_s - least_s};
  if (device_sent_s >= best_until_s_ || from_above_.empty()) {
    from_above_.push_back(bound);
    best_until_s_ = device_sent_s + kWhile;
  } else if (bound.theta_s < from_above_.back().theta_s) {
    from_above_.back() = bound;
  }
  forget(device_sent_s);
}

void PingClock::restart() {
  from_below_.clear();
  from_above_.clear();
  best_until_s_ = 0.0;
}

void PingClock::forget(double newest_s) {
  const double oldest_s = newest_s - options_.window_s;
  while (!from_below_.empty() && from_below_.front().t_s < oldest_s) from_below_.pop_front();
  while (!from_above_.empty() && from_above_.front().t_s < oldest_s) from_above_.pop_front();
}

/// By how much a bound is weaker at another time.
double PingClock::widened(const Bound& bound, double at_s) const {
  const double apart_s = bound.t_s - at_s;
  return 0.5 * options_.drift_per_s * apart_s * apart_s;
}

/// The least theta at at_s of a tangent with this slope; convex in the slope.
double PingClock::least(double slope, double at_s) const {
  double value = -std::numeric_limits<double>::infinity();
  for (const Bound& bound : from_below_) {
    value = std::max(value, bound.theta_s - widened(bound, at_s) - slope * (bound.t_s - at_s));
  }
  return value;
}

/// The greatest; concave in the slope.
double PingClock::most(double slope, double at_s) const {
  double value = std::numeric_limits<double>::infinity();
  for (const Bound& bound : from_above_) {
    value = std::min(value, bound.theta_s + widened(bound, at_s) - slope * (bound.t_s - at_s));
  }
  return value;
}

std::optional<PingEstimate> PingClock::at(double device_s) const {
  if (from_below_.empty() || from_above_.empty()) return std::nullopt;
  const Range all{-options_.largest_skew, options_.largest_skew};
  const auto room = [&](double slope) { return most(slope, device_s) - least(slope, device_s); };
  const double best = highest(all, room);
  if (room(best) < 0.0) return std::nullopt;
  // The slopes of all lines that keep to the bounds, and the lowest and highest of these lines.
  const Range slopes{last_at_least_zero(best, all.low, room),
                     last_at_least_zero(best, all.high, room)};
  const double lowest =
      least(highest(slopes, [&](double slope) { return -least(slope, device_s); }), device_s);
  const double top =
      most(highest(slopes, [&](double slope) { return most(slope, device_s); }), device_s);
  PingEstimate estimate;
  estimate.at_s = device_s;
  estimate.theta_s = 0.5 * (lowest + top);
  estimate.ci95_s = 0.5 * (top - lowest);
  estimate.rate = 1.0 + 0.5 * (slopes.low + slopes.high);
  estimate.rate_ci95 = 0.5 * (slopes.high - slopes.low);
  return estimate;
}

}  // namespace searig::acquisition
