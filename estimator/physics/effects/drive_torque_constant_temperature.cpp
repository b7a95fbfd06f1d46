#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class DriveTorqueConstantTemperature final : public SingleAmplitude {
 public:
  DriveTorqueConstantTemperature()
      : SingleAmplitude(
            {.name = "drive.torque_constant_temperature",
             .path = Path::drive,
             .title = "the motor gives less torque per ampere when its winding is warm",
             .equation = "torque_constant*(1 + per_c*(winding temperature - reference))",
             .looks_like = "the slope over current follows the winding temperature",
             .confused_with = "spring.temperature",
             .separated_by = "hold a known weight while the motor warms up",
             .channel = "winding_temperature_c",
             .source = "remanence of permanent magnets, about -0.1 % (ferrite -0.2 %) per kelvin"},
            {{"per_c", -0.1, 0.1, "relative change of the torque constant per kelvin"},
             {"reference_c", -50, 200, "where the torque constant holds"}},
            RelativeTo::motor_gain) {}

  bool applies(const Motion& m) const override { return m.has_drive() && !m.winding_c.empty(); }

  std::vector<std::vector<double>> shape_grid(const Motion& m) const override {
    return {{m.reference_c}};
  }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double> shape) const override {
    return (as_array(m.current) * (as_array(m.winding_c) - shape[0])).matrix();
  }
};

}  // namespace

const Effect& drive_torque_constant_temperature() {
  static const DriveTorqueConstantTemperature effect;
  return effect;
}

}  // namespace searig::estimator
