#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class DriveViscous final : public SingleAmplitude {
 public:
  DriveViscous()
      : SingleAmplitude({.name = "drive.viscous",
                         .path = Path::drive,
                         .title = "friction that grows with the speed of the gear train",
                         .equation = "- b*w",
                         .looks_like = "an error in proportion to speed",
                         .confused_with = "drive.coulomb, drive.inertia, rig.delay",
                         .separated_by = "constant speeds over two decades",
                         .channel = "input_velocity_rad_s",
                         .source = "linear bearing and lubricant drag"},
                        {{"b_nm_s_per_rad", 0, unlimited, "viscous friction at the gear output"}}) {
  }

  bool applies(const Motion& m) const override { return m.has_drive(); }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] > 0; }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double>) const override {
    return (-as_array(m.w)).matrix();
  }
};

}  // namespace

const Effect& drive_viscous() {
  static const DriveViscous effect;
  return effect;
}

}  // namespace searig::estimator
