// The motions of a spec as angles over time.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/session/motion_spec.h"

namespace searig::app {
namespace {

using Kind = MotionSpec::Kind;

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

double deflection(const MotionSpec& spec, double t) {
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

std::vector<double> times(double seconds, double hz) {
  std::vector<double> out(std::size_t(seconds * hz) + 1);
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = double(i) / hz;
  return out;
}

std::vector<double> ramp(const std::vector<double>& from_to, const std::vector<double>& t) {
  std::vector<double> out;
  for (const double s : t)
    out.push_back(from_to.front() + (from_to.back() - from_to.front()) * s / t.back());
  return out;
}

}  // namespace

acquisition::Recording recording_of(const MotionSpec& spec) {
  acquisition::Recording out;
  out.name = "simulated";
  out.one_clock = true;
  out.module.name = "module";
  out.module.t_s = times(spec.seconds, spec.module_hz);
  std::vector<double> theta, q_o;
  for (const double t : out.module.t_s) {
    theta.push_back(deflection(spec, t));
    q_o.push_back(spec.output_rad * multisine(t + 3.0, 0.7));
  }
  // Twice, so that speed is continuous and acceleration finite.
  const bool steps = spec.kind == Kind::staircase || spec.kind == Kind::hold;
  const auto width = std::size_t((steps ? 0.2 : 0.06) * spec.module_hz);
  theta = rounded_off(rounded_off(theta, width), width);
  std::vector<double> q_i = q_o;
  for (std::size_t i = 0; i < q_i.size(); ++i) q_i[i] += theta[i];
  out.module.channels = {{"input_angle_rad", q_i}, {"output_angle_rad", q_o}};
  const auto add_temperature = [&](const char* name, const std::vector<double>& from_to) {
    if (!from_to.empty()) out.module.channels.push_back({name, ramp(from_to, out.module.t_s)});
  };
  add_temperature("spring_temperature_c", spec.spring_c);
  add_temperature("winding_temperature_c", spec.winding_c);
  out.loadcell.name = "loadcell";
  out.loadcell.t_s = times(spec.seconds, spec.loadcell_hz);
  out.loadcell.channels = {{"torque_nm", std::vector<double>(out.loadcell.t_s.size(), 0.0)}};
  return out;
}

}  // namespace searig::app
