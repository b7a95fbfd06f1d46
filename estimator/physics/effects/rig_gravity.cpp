#include "estimator/physics/sine.h"

namespace searig::estimator {
namespace {

class RigGravity final : public Sine {
 public:
  RigGravity()
      : Sine({.name = "rig.gravity",
              .path = Path::rig,
              .title = "the lever's weight pulls between spring and load cell",
              .equation = "- torque*sin(q_o + phase)",
              .looks_like = "an error that depends on where the output stands, at rest too",
              .confused_with =
                  "rig.inertia (in a swinging motion), spring.cubic, a load-cell offset",
              .separated_by = "the unloaded lever at several angles, or the rig laid on its side",
              .channel = "output_angle_rad",
              .source = "weight of a lever, m*g*l"},
             {{"torque_nm", 0, unlimited, "weight times distance of the centre of mass"},
              {"phase_rad", -1e3, 1e3, "output angle from hanging down, at q_o = 0"}}) {}

  bool applies(const Motion& m) const override { return !m.q_o.empty(); }

  Eigen::MatrixXd features(const Motion& m, std::span<const double>) const override {
    return columns(m.q_o, 1.0);
  }
};

}  // namespace

const Effect& rig_gravity() {
  static const RigGravity effect;
  return effect;
}

}  // namespace searig::estimator
