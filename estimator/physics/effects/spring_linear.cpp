#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class SpringLinear final : public SingleAmplitude {
 public:
  SpringLinear()
      : SingleAmplitude({.name = "spring.linear",
                         .path = Path::spring,
                         .title = "the spring itself",
                         .equation = "+ k*theta",
                         .looks_like = "torque in proportion to the deflection",
                         .confused_with = "",
                         .separated_by = "",
                         .channel = "deflection_rad",
                         .source = "paper, equation (1) (Hooke)"},
                        {{"k_nm_per_rad", 0, unlimited, "torsional stiffness"}}) {}

  bool applies(const Motion& m) const override { return m.has_spring(); }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] > 0; }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double>) const override {
    return as_array(m.theta).matrix();
  }
};

}  // namespace

const Effect& spring_linear() {
  static const SpringLinear effect;
  return effect;
}

}  // namespace searig::estimator
