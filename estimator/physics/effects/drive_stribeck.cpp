#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class DriveStribeck final : public SingleAmplitude {
 public:
  DriveStribeck()
      : SingleAmplitude(
            {.name = "drive.stribeck",
             .path = Path::drive,
             .title = "the gear train sticks more at low speed than it slides at high speed",
             .equation = "- torque*exp(-(w/velocity)^2)*tanh(w/smoothing)",
             .looks_like = "friction that falls as the speed rises from zero",
             .confused_with = "drive.coulomb, drive.viscous",
             .separated_by = "constant speeds from very low on",
             .channel = "input_velocity_rad_s",
             .source = "B. Armstrong-Helouvry et al., Automatica 30, 1994"},
            {{"torque_nm", 0, unlimited, "breakaway torque above the sliding friction"},
             {"velocity_rad_s", 1e-6, 1e3, "Stribeck velocity"}}) {}

  bool applies(const Motion& m) const override { return m.has_drive(); }

  std::vector<std::vector<double>> shape_grid(const Motion& m) const override {
    return logarithmic_grid(0.03 * reach(m.w), 0.45 * reach(m.w), 8);
  }

  std::size_t free_shape(std::span<const double>) const override { return 1; }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] > 0; }

  Range shape_range(const Motion& m, std::span<const double>, std::size_t) const override {
    return {0.02 * reach(m.w), 0.5 * reach(m.w)};
  }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double> shape) const override {
    const auto w = as_array(m.w);
    return (-(-(w / shape[0]).square()).exp() * (w / m.smoothing_rad_s).tanh()).matrix();
  }
};

}  // namespace

const Effect& drive_stribeck() {
  static const DriveStribeck effect;
  return effect;
}

}  // namespace searig::estimator
