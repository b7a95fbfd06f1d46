#include "tests/proving/rig/motion.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <stdexcept>

namespace searig::proving {
namespace {

using Shape = std::function<double(double)>;  // seconds into the segment -> -1..1
struct Segment {
  Shape motor, hand;
};

constexpr double tau = 2.0 * std::numbers::pi;

/// Random phases and 1/sqrt(f) amplitudes; scaled so that peaks stay near one.
Shape multisine(double low_hz, double high_hz, int lines, Random& random) {
  struct Line {
    double amplitude, hz, phase;
  };
  std::vector<Line> sum;
  double power = 0.0;
  for (int i = 0; i < lines; ++i) {
    const double hz = random.log_uniform(low_hz, high_hz);
    sum.push_back({1.0 / std::sqrt(hz), hz, random.uniform(0.0, tau)});
    power += 0.5 / hz;
  }
  const double scale = 0.4 / std::sqrt(power);
  return [sum, scale](double t) {
    double value = 0.0;
    for (const auto& l : sum) value += l.amplitude * std::sin(tau * l.hz * t + l.phase);
    return scale * value;
  };
}

double triangle(double cycles) {
  return 2.0 / std::numbers::pi * std::asin(std::sin(tau * cycles));
}

Shape triangles_at_rates(double duration, std::vector<double> rates_hz) {
  return [=](double t) {
    const double each = duration / static_cast<double>(rates_hz.size());
    const auto i = std::min(rates_hz.size() - 1, static_cast<std::size_t>(t / each));
    return triangle(rates_hz[i] * (t - static_cast<double>(i) * each));
  };
}

Shape held_levels(double duration, int count, Random& random) {
  std::vector<double> levels;
  for (int i = 0; i < count; ++i) levels.push_back((i % 2 ? 1 : -1) * random.uniform(0.25, 1.0));
  return [=](double t) {
    return levels[std::min<std::size_t>(levels.size() - 1,
                                        static_cast<std::size_t>(t / duration * count))];
  };
}

Shape chirp(double duration, double low_hz, double high_hz) {
  const double rate = std::log(high_hz / low_hz) / duration;
  return [=](double t) {
    const double hz = low_hz * std::exp(rate * t);
    return std::sin(tau * (hz - low_hz) / rate) / std::sqrt(1.0 + hz / (3.0 * low_hz));
  };
}

Shape growing(double duration, double hz, double first, int levels) {
  return [=](double t) {
    const int level = std::min(levels - 1, static_cast<int>(t / duration * levels));
    return (first + (1.0 - first) * level / (levels - 1)) * std::sin(tau * hz * t);
  };
}

Shape constant(double value) {
  return [value](double) { return value; };
}

Shape sine(double hz, double amplitude) {
  return [=](double t) { return amplitude * std::sin(tau * hz * t); };
}

Segment segment(const std::string& name, double s, double pace, Random& random) {
  const auto hand = [&](double scale) -> Shape {
    auto shape = multisine(0.1 * pace, 0.9 * pace, 6, random);
    return [shape, scale](double t) { return scale * shape(t); };
  };
  if (name == "multisine") return {multisine(0.12 * pace, 1.6 * pace, 9, random), hand(1.0)};
  if (name == "triangles")
    return {triangles_at_rates(s, {0.13 * pace, 0.35 * pace, 0.9 * pace}), hand(0.4)};
  if (name == "staircase") return {held_levels(s, std::max(2, int(s / 3.0)), random), hand(0.15)};
  if (name == "steps") return {held_levels(s, std::max(2, int(s / 6.0)), random), constant(0.0)};
  if (name == "chirp") return {chirp(s, 0.12 * pace, 2.6 * pace), hand(0.5)};
  if (name == "hand") return {multisine(0.05 * pace, 0.4 * pace, 5, random), hand(1.8)};
  if (name == "growing") return {growing(s, 0.45 * pace, 0.15, 6), hand(0.1)};
  if (name == "rest") return {constant(0.0), constant(0.0)};
  if (name == "slow_triangle") return {triangles_at_rates(s, {0.12 * pace}), constant(0.0)};
  if (name == "sine") return {sine(1.0, 1.0), constant(0.0)};
  if (name == "constant_speed") return {triangles_at_rates(s, {0.035}), constant(0.0)};
  if (name == "slow_sweep") return {triangles_at_rates(s, {0.05}), hand(0.15)};
  if (name == "fast_burst") return {multisine(1.5, 3.2, 7, random), hand(0.4)};
  if (name == "small") {
    auto motor = multisine(0.15 * pace, 1.2 * pace, 8, random);
    return {[motor](double t) { return 0.35 * motor(t); }, hand(0.3)};
  }
  throw std::invalid_argument("no motion is called " + name);
}

/// Zero at both ends of a segment and one inside: segments join without a jump.
double window(double t, double duration) {
  const double edge = 0.6;
  const double x = std::clamp(std::min(t, duration - t) / edge, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

}  // namespace

double Motion::at(const std::vector<double>& samples, double t_s) {
  const double x = std::clamp(t_s * rate_hz, 0.0, static_cast<double>(samples.size() - 2));
  const auto i = static_cast<std::size_t>(x);
  return samples[i] + (x - static_cast<double>(i)) * (samples[i + 1] - samples[i]);
}

Motion plan_motion(const MotionPlan& plan, double duration_s, Random random) {
  std::vector<Segment> segments;
  std::vector<double> starts{0.0};
  for (std::size_t i = 0; i < plan.segments.size(); ++i) {
    const double lasts = plan.shares[i] * duration_s;
    segments.push_back(segment(plan.segments[i], lasts, plan.pace, random));
    starts.push_back(starts.back() + lasts);
  }
  Motion motion;
  const auto count = static_cast<std::size_t>(duration_s * Motion::rate_hz) + 2;
  std::size_t i = 0;
  for (std::size_t n = 0; n < count; ++n) {
    const double t = static_cast<double>(n) / Motion::rate_hz;
    if (i + 1 < segments.size() && t >= starts[i + 1]) ++i;
    const double inside = t - starts[i];
    const double fade =
        segments.size() > 1 ? window(inside, starts[i + 1] - starts[i]) : std::min(1.0, t / 0.5);
    motion.motor_rad.push_back(plan.bias_rad +
                               plan.motor_amplitude_rad * fade * segments[i].motor(inside));
    motion.hand_rad.push_back(plan.hand_amplitude_rad * fade * segments[i].hand(inside));
  }
  return motion;
}

}  // namespace searig::proving
