#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class DriveCoulomb final : public SingleAmplitude {
 public:
  DriveCoulomb()
      : SingleAmplitude(
            {.name = "drive.coulomb",
             .path = Path::drive,
             .title = "dry friction in the gear train",
             .equation = "- torque*tanh(w/smoothing)",
             .looks_like =
                 "a jump of twice the torque at each reversal, the same at every speed and load",
             .confused_with = "drive.viscous, drive.stribeck, drive.load_friction",
             .separated_by = "constant speeds over two decades at two loads",
             .channel = "input_velocity_rad_s",
             .source = "C. Canudas de Wit et al., IEEE T. Robotics and Automation 7, 1991"},
            {{"torque_nm", 0, unlimited, "dry friction at the gear output"},
             {"smoothing_rad_s", 1e-9, 10, "speed over which the sign turns"}}) {}

  bool applies(const Motion& m) const override { return m.has_drive(); }

  std::vector<std::vector<double>> shape_grid(const Motion& m) const override {
    return {{m.smoothing_rad_s}};
  }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] > 0; }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double> shape) const override {
    return (-(as_array(m.w) / shape[0]).tanh()).matrix();
  }
};

}  // namespace

const Effect& drive_coulomb() {
  static const DriveCoulomb effect;
  return effect;
}

}  // namespace searig::estimator
