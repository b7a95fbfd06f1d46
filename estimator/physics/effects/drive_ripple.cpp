#include <algorithm>
#include <cmath>

#include "estimator/physics/sine.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class DriveRipple final : public Sine {
 public:
  DriveRipple()
      : Sine({.name = "drive.ripple",
              .path = Path::drive,
              .title = "the drive's torque ripples with its angle (cogging, gear teeth)",
              .equation = "- torque*sin(cycles_per_rad*q_i + phase)",
              .looks_like = "a wave over the input angle, the same at every speed",
              .confused_with = "a wave in the input encoder, periodic noise in time",
              .separated_by = "slow constant speeds over several waves, at two speeds",
              .channel = "input_angle_rad",
              .source = "cogging torque; J. Gieras, Permanent Magnet Motor Technology, 2002"},
             {{"torque_nm", 0, unlimited, "amplitude at the gear output"},
              {"cycles_per_rad", 1e-3, 1e5, "radians of ripple per radian of q_i"},
              {"phase_rad", -1e3, 1e3, "ripple angle at q_i = 0"}}) {}

  bool applies(const Motion& m) const override { return m.has_drive() && !m.q_i.empty(); }

  /// From two waves over the angle's range up to what the samples resolve, in steps that keep the
  /// phase within a quarter wave at the ends of the range.
  std::vector<std::vector<double>> shape_grid(const Motion& m) const override {
    const auto [low, high] = std::ranges::minmax_element(m.q_i);
    const double range = *high - *low;
    if (!(range > 0)) return {};
    const double step = 0.5 * M_PI / range;
    std::vector<std::vector<double>> out;
    for (double c = 4.0 * M_PI / range; out.size() < 160; c += step) out.push_back({c});
    return out;
  }

  Range shape_range(const Motion&, std::span<const double>, std::size_t) const override {
    return {1e-2, 1e5};
  }

  Eigen::MatrixXd features(const Motion& m, std::span<const double> shape) const override {
    return columns(m.q_i, shape[0]);
  }
  std::size_t free_shape(std::span<const double>) const override { return 1; }

  std::vector<double> shape(const Term& term) const override {
    return {term.parameters.at("cycles_per_rad")};
  }
  Term term(const Eigen::VectorXd& amplitudes, std::span<const double> shape, const Model& model,
            const Motion& motion) const override {
    Term out = Sine::term(amplitudes, shape, model, motion);
    out.parameters["cycles_per_rad"] = shape[0];
    return out;
  }
};

}  // namespace

const Effect& drive_ripple() {
  static const DriveRipple effect;
  return effect;
}

}  // namespace searig::estimator
