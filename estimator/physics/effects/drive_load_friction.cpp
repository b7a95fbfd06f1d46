#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class DriveLoadFriction final : public SingleAmplitude {
 public:
  DriveLoadFriction()
      : SingleAmplitude(
            {.name = "drive.load_friction",
             .path = Path::drive,
             .title = "gear friction that grows with the load",
             .equation = "- share*abs(T_spring)*tanh(w/smoothing)",
             .looks_like = "friction that vanishes at no load: a butterfly over the torque",
             .confused_with = "drive.coulomb, drive.motor efficiency",
             .separated_by = "several loads at one speed, in both directions",
             .channel = "spring_torque_nm",
             .source = "gear efficiency; S. Wu, G. Duong, ISA Trans. 2017"},
            {{"share", 0, 1, "friction torque over load torque"},
             {"backdriving_ratio", 0, 10, "share when back-driven over share when driving", 1.0}}) {
  }

  bool applies(const Motion& m) const override { return m.has_drive() && !m.spring_nm.empty(); }

  std::vector<std::vector<double>> shape_grid(const Motion&) const override { return {{1.0}}; }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] > 0; }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double> shape) const override {
    const auto load = as_array(m.spring_nm);
    const auto w = as_array(m.w);
    const auto ratio = (load * w < 0).select(Eigen::ArrayXd::Constant(load.size(), shape[0]), 1.0);
    return (-load.abs() * ratio * (w / m.smoothing_rad_s).tanh()).matrix();
  }
};

}  // namespace

const Effect& drive_load_friction() {
  static const DriveLoadFriction effect;
  return effect;
}

}  // namespace searig::estimator
