#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class DriveCurrentOffset final : public SingleAmplitude {
 public:
  DriveCurrentOffset()
      : SingleAmplitude(
            {.name = "drive.current_offset",
             .path = Path::drive,
             .title = "the current sensor reads an offset",
             .equation = "measured I is true I + offset",
             .looks_like = "a constant torque against spring and load cell alike",
             .confused_with = "an offset of the deflection together with one of the load cell",
             .separated_by = "the motor switched off: the current must read zero",
             .channel = "current_a",
             .source = "current-shunt amplifier offset"},
            {{"offset_a", -1e3, 1e3, "reading at no current"}}, RelativeTo::motor_gain) {}

  bool applies(const Motion& m) const override { return m.has_drive(); }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double>) const override {
    return Eigen::VectorXd::Constant(Eigen::Index(m.size()), -1.0);
  }
};

}  // namespace

const Effect& drive_current_offset() {
  static const DriveCurrentOffset effect;
  return effect;
}

}  // namespace searig::estimator
