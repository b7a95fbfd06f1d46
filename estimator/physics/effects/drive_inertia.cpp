#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class DriveInertia final : public SingleAmplitude {
 public:
  DriveInertia()
      : SingleAmplitude(
            {.name = "drive.inertia",
             .path = Path::drive,
             .title = "torque spent on accelerating the gear train",
             .equation = "- efficiency*j*a",
             .looks_like = "an error in proportion to acceleration, none at constant speed",
             .confused_with = "rig.inertia, spring.viscous",
             .separated_by = "small fast motions against large slow ones",
             .channel = "input_acceleration_rad_s2",
             .source =
                 "paper, equation (2), with the sign of the torque that does not reach the output"},
            {{"j_kg_m2", 0, unlimited,
              "sum of J_i r_i at the gear output, for the model's efficiency"}},
            RelativeTo::efficiency) {}

  bool applies(const Motion& m) const override { return m.has_drive(); }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] > 0; }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double>) const override {
    return (-as_array(m.a)).matrix();
  }
};

}  // namespace

const Effect& drive_inertia() {
  static const DriveInertia effect;
  return effect;
}

}  // namespace searig::estimator
