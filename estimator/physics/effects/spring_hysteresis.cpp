#include <algorithm>
#include <cmath>

#include "estimator/physics/branches.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class SpringHysteresis final : public Branches {
 public:
  SpringHysteresis()
      : Branches(
            {.name = "spring.hysteresis",
             .path = Path::spring,
             .title = "the spring's torque depends on where it came from (inner friction)",
             .equation = "+ torque*z, dz = (1 - z^2*[z*dtheta > 0])*dtheta/yield (Bouc-Wen)",
             .looks_like = "a loop of the same width at every speed, closed after a reversal",
             .confused_with = "spring.viscous, spring.relaxation, spring.deadzone",
             .separated_by = "triangles of one amplitude at two speeds, with small ones inside",
             .channel = "deflection_rad",
             .source = "Y.-K. Wen, J. Eng. Mech. 102, 1976; loops, not parameters, are unique"},
            {"torque", "_nm", "torque at which it saturates", false},
            {"yield", "_rad", "deflection after a reversal at which it saturates", false}) {}

  bool applies(const Motion& m) const override { return m.has_spring(); }

  std::vector<std::vector<double>> shape_grid(const Motion& m) const override {
    return logarithmic_grid(0.01 * reach(m.theta), 0.7 * reach(m.theta), 10);
  }

  Range shape_range(const Motion& m, std::span<const double>, std::size_t) const override {
    return {0.008 * reach(m.theta), 0.8 * reach(m.theta)};
  }

 protected:
  /// z follows the deflection in closed form over each step: tanh while loading, linear while
  /// unloading. Rate-independent: time does not occur.
  Eigen::VectorXd column(const Motion& m, double yield) const override {
    Eigen::VectorXd out = Eigen::VectorXd::Zero(Eigen::Index(m.size()));
    double z = 0.0;
    for (std::size_t i = 1; i < m.size(); ++i) {
      double step = (m.theta[i] - m.theta[i - 1]) / yield;
      if (z * step < 0) {  // unloading is linear, as far as zero
        const double to_zero = std::min(std::abs(step), std::abs(z));
        z += std::copysign(to_zero, step);
        step -= std::copysign(to_zero, step);
      }
      const double gain = std::tanh(step);  // tanh(a + b) from tanh(a) and tanh(b)
      z = (z + gain) / (1.0 + z * gain);
      out[Eigen::Index(i)] = z;
    }
    return out;
  }
};

}  // namespace

const Effect& spring_hysteresis() {
  static const SpringHysteresis effect;
  return effect;
}

}  // namespace searig::estimator
