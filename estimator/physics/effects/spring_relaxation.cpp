#include <cmath>

#include "estimator/physics/branches.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class SpringRelaxation final : public Branches {
 public:
  SpringRelaxation()
      : Branches({.name = "spring.relaxation",
                  .path = Path::spring,
                  .title = "the spring gives way slowly while it is held (viscoelasticity)",
                  .equation = "+ k1*(theta - x), dx/dt = (theta - x)/tau",
                  .looks_like = "torque that decays in seconds after a step of deflection",
                  .confused_with =
                      "spring.viscous (short tau), spring.hysteresis, rig.zero_drift (long tau)",
                  .separated_by = "steps held for three times tau, and triangles at two speeds",
                  .channel = "deflection_rate_rad_s",
                  .source = "standard linear solid; W. Findley et al., Creep and Relaxation, 1976"},
                 {"k", "_nm_per_rad", "stiffness of the branch", true},
                 {"tau", "_s", "time constant of the branch", false}) {}

  bool applies(const Motion& m) const override { return m.has_spring(); }

  std::vector<std::vector<double>> shape_grid(const Motion& m) const override {
    if (m.size() < 2) return {};
    return logarithmic_grid(0.08, 0.5 * m.t.back(), 12);
  }

  Range shape_range(const Motion& m, std::span<const double>, std::size_t) const override {
    return {0.06, 0.6 * m.t.back()};
  }

 protected:
  /// theta - x, exact for a deflection that is straight between samples:
  /// with u = theta - x, du/dt = dtheta/dt - u/tau.
  Eigen::VectorXd column(const Motion& m, double tau) const override {
    Eigen::VectorXd u = Eigen::VectorXd::Zero(Eigen::Index(m.size()));
    for (std::size_t i = 1; i < m.size(); ++i) {
      const double dt = m.t[i] - m.t[i - 1];
      const double decay = std::exp(-dt / tau);
      const double rate = (m.theta[i] - m.theta[i - 1]) / dt;
      u[Eigen::Index(i)] = decay * u[Eigen::Index(i) - 1] + (1.0 - decay) * tau * rate;
    }
    return u;
  }
};

}  // namespace

const Effect& spring_relaxation() {
  static const SpringRelaxation effect;
  return effect;
}

}  // namespace searig::estimator
