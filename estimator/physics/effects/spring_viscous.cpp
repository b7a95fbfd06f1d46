#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class SpringViscous final : public SingleAmplitude {
 public:
  SpringViscous()
      : SingleAmplitude(
            {.name = "spring.viscous",
             .path = Path::spring,
             .title = "the spring resists being deflected fast (damping)",
             .equation = "+ c*dtheta/dt",
             .looks_like = "a loop that widens in proportion to speed and is gone at rest",
             .confused_with = "rig.delay, rig.lag, spring.relaxation",
             .separated_by =
                 "the same motion at several speeds, with the current recorded: a late load cell "
                 "shows against spring and drive alike, damping only against the spring",
             .channel = "deflection_rate_rad_s",
             .source = "paper, equation (12)"},
            {{"c_nm_s_per_rad", 0, unlimited, "damping coefficient"}}) {}

  bool applies(const Motion& m) const override { return m.has_spring(); }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] > 0; }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double>) const override {
    return as_array(m.theta_rate).matrix();
  }
};

}  // namespace

const Effect& spring_viscous() {
  static const SpringViscous effect;
  return effect;
}

}  // namespace searig::estimator
