#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class SpringTemperature final : public SingleAmplitude {
 public:
  SpringTemperature()
      : SingleAmplitude(
            {.name = "spring.temperature",
             .path = Path::spring,
             .title = "the spring softens or stiffens with its temperature",
             .equation = "k*(1 + per_c*(T_spring_temperature - reference))",
             .looks_like = "the slope follows the temperature, up and down",
             .confused_with = "spring.mullins, spring.relaxation with a long time",
             .separated_by = "the same motion cold, warm and cold again, at rest in between",
             .channel = "spring_temperature_c",
             .source = "elastomer stiffness, L. Treloar, The Physics of Rubber Elasticity, 1975"},
            {{"per_c", -0.1, 0.1, "relative change of k per kelvin"},
             {"reference_c", -50, 200, "where k holds"}},
            RelativeTo::stiffness) {}

  bool applies(const Motion& m) const override { return m.has_spring() && !m.spring_c.empty(); }

  std::vector<std::vector<double>> shape_grid(const Motion& m) const override {
    return {{m.reference_c}};
  }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double> shape) const override {
    return (as_array(m.theta) * (as_array(m.spring_c) - shape[0])).matrix();
  }
};

}  // namespace

const Effect& spring_temperature() {
  static const SpringTemperature effect;
  return effect;
}

}  // namespace searig::estimator
