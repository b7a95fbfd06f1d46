#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class SpringDeadzone final : public SingleAmplitude {
 public:
  SpringDeadzone()
      : SingleAmplitude(
            {.name = "spring.deadzone",
             .path = Path::spring,
             .title = "play: small deflections bring no torque",
             .equation =
                 "theta acts only beyond +-half_width: k*(theta - clamp(theta, +-half_width))",
             .looks_like =
                 "slope zero within a fixed band of deflection, a step of k*half_width across it",
             .confused_with = "spring.cubic, spring.hysteresis",
             .separated_by = "slow crossings of zero at two amplitudes: the band stays where it is",
             .channel = "deflection_rad",
             .source = "piecewise linear play; J. Nordin, P.-O. Gutman, Automatica 38, 2002"},
            {{"half_width_rad", 0, 3.2, "half the play"}}) {}

  bool applies(const Motion& m) const override { return m.has_spring(); }

  std::vector<std::vector<double>> shape_grid(const Motion& m) const override {
    return logarithmic_grid(0.005 * reach(m.theta), 0.6 * reach(m.theta), 12);
  }

  // The amplitude is the stiffness; the file's only parameter is the shape.
  Eigen::VectorXd amplitudes(const Term&, const Model& model) const override {
    return Eigen::VectorXd::Constant(1, scale_of(RelativeTo::stiffness, model));
  }
  std::vector<double> shape(const Term& term) const override {
    return {term.parameters.at("half_width_rad")};
  }
  Term term(const Eigen::VectorXd&, std::span<const double> shape, const Model&,
            const Motion&) const override {
    return {name(), {{"half_width_rad", shape[0]}}};
  }

  std::size_t free_shape(std::span<const double>) const override { return 1; }

  std::string_view tied_to() const override { return "spring.linear"; }

  Range shape_range(const Motion& m, std::span<const double>, std::size_t) const override {
    return {0.002 * reach(m.theta), 0.7 * reach(m.theta)};
  }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double> shape) const override {
    return (-as_array(m.theta).cwiseMin(shape[0]).cwiseMax(-shape[0])).matrix();
  }
};

}  // namespace

const Effect& spring_deadzone() {
  static const SpringDeadzone effect;
  return effect;
}

}  // namespace searig::estimator
