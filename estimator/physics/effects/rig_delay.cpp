#include <algorithm>

#include "estimator/physics/observation.h"

namespace searig::estimator {
namespace {

class RigDelay final : public Observation {
 public:
  RigDelay()
      : Observation(
            {.name = "rig.delay",
             .path = Path::observation,
             .title = "the load cell reports late",
             .equation = "T_loadcell(t) = T(t - delay)",
             .looks_like = "an error in proportion to the torque's rate",
             .confused_with = "rig.lag, spring.viscous with drive.viscous",
             .separated_by = "a sharp knock on the lever; motions above 0.3/(2*pi*delay) Hz",
             .channel = "deflection_rate_rad_s",
             .source = "transport delay of an averaging or buffered converter"},
            {{"delay_s", -10, 10, "beyond what the clock map leaves open"}}) {}

  std::vector<std::vector<double>> shape_grid(const Motion&) const override {
    return {{0.005}, {0.01}, {0.02}, {0.04}, {0.08}, {0.15}};
  }

  Range shape_range(const Motion&, std::span<const double>, std::size_t) const override {
    return {0.0005, 0.3};
  }

  Eigen::VectorXd seen(const std::vector<double>& t, const Eigen::VectorXd& x,
                       double seconds) const override {
    if (x.size() < 2) return x;
    Eigen::VectorXd out(x.size());
    Eigen::Index j = 0;
    const Eigen::Index last = x.size() - 1;
    for (Eigen::Index i = 0; i <= last; ++i) {
      const double at = t[std::size_t(i)] - seconds;
      while (j > 0 && t[std::size_t(j)] > at) --j;
      while (j + 1 < last && t[std::size_t(j) + 1] <= at) ++j;
      const double from = t[std::size_t(j)], to = t[std::size_t(j) + 1];
      const double u = std::min(1.0, std::max(0.0, (at - from) / (to - from)));
      out[i] = x[j] + u * (x[j + 1] - x[j]);
    }
    return out;
  }
};

}  // namespace

const Effect& rig_delay() {
  static const RigDelay effect;
  return effect;
}

}  // namespace searig::estimator
