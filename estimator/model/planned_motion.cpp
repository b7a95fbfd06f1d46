#include "estimator/model/planned_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace searig::estimator {
namespace {

using Kind = PlannedMotion::Kind;

constexpr std::array<std::pair<std::string_view, Kind>, 5> kinds{{
    {"triangle", Kind::triangle},
    {"sine", Kind::sine},
    {"multisine", Kind::multisine},
    {"staircase", Kind::staircase},
    {"hold", Kind::hold},
}};

constexpr double two_pi = 2.0 * std::numbers::pi;

/// Five sines up to `highest_hz` that never meet again, started at rest.
double multisine(double t, double highest_hz) {
  double sum = 0.0;
  for (int i = 0; i < 5; ++i) {
    const double hz = highest_hz * (1.0 - 0.19 * i) / (1.0 + 0.013 * i * i);
    sum += std::sin(two_pi * hz * t + 1.7 * i) - std::sin(1.7 * i);
  }
  return sum / 5.0;
}

/// Between -1 and 1, starting from 0.
double triangle(double cycles) {
  const double phase = cycles + 0.25 - std::floor(cycles + 0.25);
  return 1.0 - 4.0 * std::abs(phase - 0.5);
}

/// Up to 1, down to -1 and back in steps of a quarter, `per_second` of them.
double staircase(double t, double per_second) {
  const double step = std::floor(t * per_second);
  return std::round(4.0 * triangle(step / 16.0)) / 4.0;
}

double shape(Kind kind, double t, double hz) {
  switch (kind) {
    case Kind::triangle:
      return triangle(hz * t);
    case Kind::sine:
      return std::sin(two_pi * hz * t);
    case Kind::multisine:
      return multisine(t, hz);
    case Kind::staircase:
      return staircase(t, hz);
    // Out, back, to the other side, back: each held for one period.
    case Kind::hold:
      return double((int(std::floor(hz * t)) % 4 == 0) - (int(std::floor(hz * t)) % 4 == 2));
  }
  return 0.0;
}

double deflection(const PlannedMotion& spec, double t) {
  const auto parts = std::max(spec.amplitudes_rad.size(), spec.frequencies_hz.size());
  const double each_s = spec.seconds / double(parts);
  const auto part = std::min(parts - 1, std::size_t(std::max(0.0, t) / each_s));
  return spec.amplitudes_rad[part % spec.amplitudes_rad.size()] *
         shape(spec.kind, t - each_s * double(part),
               spec.frequencies_hz[part % spec.frequencies_hz.size()]);
}

/// No actuator jumps: a moving average makes corners round.
std::vector<double> rounded_off(const std::vector<double>& x, std::size_t width) {
  std::vector<double> sum(x.size() + 1, 0.0), out(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) sum[i + 1] = sum[i] + x[i];
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t half = std::min({width / 2, i, x.size() - 1 - i});
    out[i] = (sum[i + half + 1] - sum[i - half]) / double(2 * half + 1);
  }
  return out;
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", x);
  return text;
}

std::string listed(const std::vector<double>& values, const char* between, const char* last) {
  std::string out;
  for (std::size_t i = 0; i < values.size(); ++i)
    out += (i == 0 ? "" : i + 1 == values.size() ? last : between) + number(values[i]);
  return out;
}

}  // namespace

std::string_view name_of(Kind kind) {
  return std::ranges::find(kinds, kind, &std::pair<std::string_view, Kind>::second)->first;
}

Kind kind_named(std::string_view name) {
  const auto it = std::ranges::find(kinds, name, &std::pair<std::string_view, Kind>::first);
  if (it == kinds.end()) throw std::out_of_range("no motion is called " + std::string(name));
  return it->second;
}

ModuleSignals angles_of(const PlannedMotion& motion, double rate_hz) {
  ModuleSignals out;
  const auto samples = std::size_t(motion.seconds * rate_hz) + 1;
  for (std::size_t i = 0; i < samples; ++i) {
    const double t = double(i) / rate_hz;
    out.t_s.push_back(t);
    out.deflection_rad.push_back(deflection(motion, t));
    out.output_angle_rad.push_back(motion.output_rad * multisine(t + 3.0, 0.7));
  }
  // Twice, so that speed is continuous and acceleration finite.
  const bool steps = motion.kind == Kind::staircase || motion.kind == Kind::hold;
  const auto width = std::size_t((steps ? 0.2 : 0.06) * rate_hz);
  out.deflection_rad = rounded_off(rounded_off(out.deflection_rad, width), width);
  out.input_angle_rad = out.output_angle_rad;
  for (std::size_t i = 0; i < samples; ++i) out.input_angle_rad[i] += out.deflection_rad[i];
  return out;
}

std::string words_for(const PlannedMotion& motion) {
  const bool steps = motion.kind == Kind::staircase || motion.kind == Kind::hold;
  std::vector<double> rates = motion.frequencies_hz;
  if (steps)
    for (double& r : rates) r = 1.0 / r;
  std::string out = motion.kind == Kind::hold ? "steps" : "a " + std::string(name_of(motion.kind));
  out += " of " + listed(motion.amplitudes_rad, ", ", " and ") + " rad";
  out += (steps                            ? ", held for "
          : motion.kind == Kind::multisine ? " up to "
                                           : " at ") +
         listed(rates, ", ", " and ") + (steps ? " s each" : " Hz");
  out += ", for " + number(motion.seconds) + " s";
  return out + (motion.output_rad > 0.0
                    ? ", the lever swinging by " + number(motion.output_rad) + " rad"
                    : ", the output locked");
}

std::string to_toml(const PlannedMotion& motion) {
  return "[motion]\nkind = \"" + std::string(name_of(motion.kind)) +
         "\"\nseconds = " + number(motion.seconds) + "\namplitudes_rad = [" +
         listed(motion.amplitudes_rad, ", ", ", ") + "]\nfrequencies_hz = [" +
         listed(motion.frequencies_hz, ", ", ", ") +
         "]\noutput_rad = " + number(motion.output_rad) + "\n";
}

}  // namespace searig::estimator
