#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class RigInertia final : public SingleAmplitude {
 public:
  RigInertia()
      : SingleAmplitude(
            {.name = "rig.inertia",
             .path = Path::rig,
             .title = "the lever between spring and load cell has mass",
             .equation = "- j*(acceleration of q_o)",
             .looks_like =
                 "an error in proportion to the output's acceleration, none while it is held",
             .confused_with = "rig.gravity, rig.lag, drive.inertia",
             .separated_by = "shake the free lever, then hold it",
             .channel = "output_acceleration_rad_s2",
             .source = "Newton, rotation"},
            {{"j_kg_m2", 0, unlimited, "moment of inertia at the output"}}) {}

  bool applies(const Motion& m) const override { return !m.a_o.empty(); }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] > 0; }

  /// A lever whose resonance on the spring lies beyond what the averaging resolves, j <
  /// k*width^2/20, cannot be told from one channel being averaged over a little more than the
  /// other.
  double feigned(const Model& model, double width_s) const override {
    return scale_of(RelativeTo::stiffness, model) * width_s * width_s / 20.0;
  }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double>) const override {
    return (-as_array(m.a_o)).matrix();
  }
};

}  // namespace

const Effect& rig_inertia() {
  static const RigInertia effect;
  return effect;
}

}  // namespace searig::estimator
