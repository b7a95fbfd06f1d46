#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "estimator/physics/sine.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

constexpr int most_waves = 4;
constexpr std::size_t over_range = 160, per_turn = 150;  // waves tried

/// torque_nm, cycles_per_rad, phase_rad; the following waves' with their number: torque2_nm.
struct Wave {
  std::string torque, cycles, phase;
  explicit Wave(int number) {
    const std::string n = number == 1 ? "" : std::to_string(number);
    torque = "torque" + n + "_nm", cycles = "cycles" + n + "_per_rad", phase = "phase" + n + "_rad";
  }
};

std::vector<Parameter> wave_parameters() {
  std::vector<Parameter> out;
  for (int number = 1; number <= most_waves; ++number) {
    const Wave wave(number);
    const auto needed = number == 1 ? std::optional<double>() : 0.0;
    out.push_back({wave.torque, 0, unlimited, "amplitude at the gear output", needed});
    out.push_back({wave.cycles, 1e-3, 1e5, "radians of ripple per radian of q_i", needed});
    out.push_back({wave.phase, -1e3, 1e3, "ripple angle at q_i = 0", needed});
  }
  return out;
}

class DriveRipple final : public Sine {
 public:
  DriveRipple()
      : Sine({.name = "drive.ripple",
              .path = Path::drive,
              .title = "the drive's torque ripples with its angle (cogging, gear teeth)",
              .equation = "- torque*sin(cycles_per_rad*q_i + phase) - torque2*sin(...)",
              .looks_like = "waves over the input angle, the same at every speed",
              .confused_with = "a wave in the input encoder, periodic noise in time",
              .separated_by = "slow constant speeds over several waves, at two speeds",
              .channel = "input_angle_rad",
              .source = "cogging torque; J. Gieras, Permanent Magnet Motor Technology, 2002"},
             wave_parameters()) {}

  bool applies(const Motion& m) const override { return m.has_drive() && !m.q_i.empty(); }

  /// From two waves over the angle's range, in steps that keep the phase within a quarter wave at
  /// the ends of the range; beyond those, whole waves per turn of the motor, where magnets, slots
  /// and teeth put them, up to what the samples resolve.
  std::vector<std::vector<double>> shape_grid(const Motion& m) const override {
    const auto [low, high] = std::ranges::minmax_element(m.q_i);
    const double range = *high - *low;
    if (!(range > 0)) return {};
    const double step = 0.5 * M_PI / range;
    std::vector<std::vector<double>> out;
    double c = 4.0 * M_PI / range;
    for (; out.size() < over_range; c += step) out.push_back({c});
    const double finest = 0.5 * M_PI / (rms(m.w) * (m.t.back() / double(m.size() - 1)));
    for (std::size_t n = 1; n <= per_turn && double(n) * m.gear_ratio < finest; ++n)
      if (double(n) * m.gear_ratio > c) out.push_back({double(n) * m.gear_ratio});
    return out;
  }

  Range shape_range(const Motion&, std::span<const double>, std::size_t) const override {
    return {1e-2, 1e5};
  }

  Eigen::MatrixXd features(const Motion& m, std::span<const double> shape) const override {
    Eigen::MatrixXd out(Eigen::Index(m.size()), 2 * Eigen::Index(shape.size()));
    for (std::size_t i = 0; i < shape.size(); ++i)
      out.middleCols(2 * Eigen::Index(i), 2) = columns(m.q_i, shape[i]);
    return out;
  }
  std::size_t free_shape(std::span<const double> shape) const override { return shape.size(); }
  bool has_branches() const override { return true; }

  std::vector<double> shape(const Term& term) const override {
    std::vector<double> out;
    for (int number = 1; number <= most_waves; ++number) {
      const auto found = term.parameters.find(Wave(number).cycles);
      if (found == term.parameters.end()) break;
      out.push_back(found->second);
    }
    return out;
  }

  std::string complaint(const Term& term) const override {
    bool ended = false;
    for (int number = 1; number <= most_waves; ++number) {
      const Wave wave(number);
      const auto has = term.parameters.count(wave.torque) + term.parameters.count(wave.cycles) +
                       term.parameters.count(wave.phase);
      if (has != 0 && has != 3)
        return "needs all of " + wave.torque + ", " + wave.cycles + " and " + wave.phase;
      if (has != 0 && ended) return "has " + wave.torque + " but not the wave before it";
      ended = ended || has == 0;
    }
    return {};
  }

  Eigen::VectorXd amplitudes(const Term& term, const Model&) const override {
    const auto waves = shape(term).size();
    Eigen::VectorXd out(2 * Eigen::Index(waves));
    for (std::size_t i = 0; i < waves; ++i) {
      const Wave wave(int(i) + 1);
      const double torque = term.parameters.at(wave.torque), phase = term.parameters.at(wave.phase);
      out[2 * Eigen::Index(i)] = torque * std::cos(phase);
      out[2 * Eigen::Index(i) + 1] = torque * std::sin(phase);
    }
    return out;
  }

  Term term(const Eigen::VectorXd& amplitudes, std::span<const double> shape, const Model&,
            const Motion&) const override {
    Term out{name(), {}};
    for (std::size_t i = 0; i < shape.size() && i < most_waves; ++i) {
      const Wave wave(int(i) + 1);
      const double a = amplitudes[2 * Eigen::Index(i)], b = amplitudes[2 * Eigen::Index(i) + 1];
      out.parameters[wave.torque] = std::hypot(a, b);
      out.parameters[wave.cycles] = shape[i];
      out.parameters[wave.phase] = std::atan2(b, a);
    }
    return out;
  }
};

}  // namespace

const Effect& drive_ripple() {
  static const DriveRipple effect;
  return effect;
}

}  // namespace searig::estimator
