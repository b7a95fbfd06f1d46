#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class DriveMotor final : public SingleAmplitude {
 public:
  DriveMotor()
      : SingleAmplitude(
            {.name = "drive.motor",
             .path = Path::drive,
             .title = "the motor's torque at the gear output",
             .equation = "efficiency*torque_constant*I",
             .looks_like = "torque in proportion to the current",
             .confused_with = "",
             .separated_by = "",
             .channel = "current_a",
             .source = "paper, equation (2)"},
            {{"torque_constant_nm_per_a", 0, unlimited, "motor constant times gear ratio"},
             {"efficiency", 0, 1, "of the gear train; only the product is seen"}},
            RelativeTo::efficiency) {}

  bool applies(const Motion& m) const override { return !m.current.empty(); }
  std::vector<double> shape(const Term&) const override { return {}; }

  /// Only the product is known from a recording: the model's efficiency stays.
  Term term(const Eigen::VectorXd& amplitudes, std::span<const double>, const Model& model,
            const Motion&) const override {
    const double efficiency = scale_of(RelativeTo::efficiency, model);
    return {name(),
            {{"torque_constant_nm_per_a", amplitudes[0] / efficiency}, {"efficiency", efficiency}}};
  }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] > 0; }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double>) const override {
    return as_array(m.current).matrix();
  }
};

}  // namespace

const Effect& drive_motor() {
  static const DriveMotor effect;
  return effect;
}

}  // namespace searig::estimator
