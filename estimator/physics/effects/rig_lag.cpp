#include <cmath>

#include "estimator/physics/observation.h"

namespace searig::estimator {
namespace {

class RigLag final : public Observation {
 public:
  RigLag()
      : Observation({.name = "rig.lag",
                     .path = Path::observation,
                     .title = "the load cell answers slowly (low pass, moving average)",
                     .equation = "T_loadcell + tau*dT_loadcell/dt = T",
                     .looks_like = "late and rounded where the torque changes fast",
                     .confused_with = "rig.delay, spring.viscous with drive.viscous",
                     .separated_by = "motions above 0.3/(2*pi*tau) Hz",
                     .channel = "deflection_rate_rad_s",
                     .source = "first-order low pass"},
                    {{"tau_s", 0, 10, "time constant"}}) {}

  /// Exact for a torque that is straight between samples.
  std::vector<std::vector<double>> shape_grid(const Motion&) const override {
    return {{0.003}, {0.006}, {0.012}, {0.025}, {0.05}, {0.1}, {0.2}};
  }

  Range shape_range(const Motion&, std::span<const double>, std::size_t) const override {
    return {0.001, 1.0};
  }

  Eigen::VectorXd seen(const std::vector<double>& t, const Eigen::VectorXd& x,
                       double seconds) const override {
    Eigen::VectorXd out(x.size());
    if (x.size() == 0) return out;
    double error = 0.0;  // x - out
    out[0] = x[0];
    for (Eigen::Index i = 1; i < x.size(); ++i) {
      const double dt = t[std::size_t(i)] - t[std::size_t(i) - 1];
      const double decay = std::exp(-dt / seconds);
      error = decay * error + (1.0 - decay) * seconds * (x[i] - x[i - 1]) / dt;
      out[i] = x[i] - error;
    }
    return out;
  }
};

}  // namespace

const Effect& rig_lag() {
  static const RigLag effect;
  return effect;
}

}  // namespace searig::estimator
