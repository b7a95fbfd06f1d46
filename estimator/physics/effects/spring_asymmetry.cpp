#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class SpringAsymmetry final : public SingleAmplitude {
 public:
  SpringAsymmetry()
      : SingleAmplitude({.name = "spring.asymmetry",
                         .path = Path::spring,
                         .title = "the spring is stiffer to one side than to the other",
                         .equation = "k*(1 + share/2) for theta > 0, k*(1 - share/2) for theta < 0",
                         .looks_like = "a bend at zero deflection: an even part, |theta|",
                         .confused_with = "a deflection offset, spring.cubic",
                         .separated_by = "equal amplitudes to both sides, slowly, several sizes",
                         .channel = "deflection_rad",
                         .source = "piecewise linear spring"},
                        {{"share", -1, 1, "difference of the two stiffnesses over their mean"}},
                        RelativeTo::stiffness) {}

  bool applies(const Motion& m) const override { return m.has_spring(); }

  bool physical(const Eigen::VectorXd& amplitude) const override { return amplitude[0] != 0; }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double>) const override {
    // k*theta*(share/2)*sign(theta) = k*share * |theta|/2
    return (0.5 * as_array(m.theta).abs()).matrix();
  }
};

}  // namespace

const Effect& spring_asymmetry() {
  static const SpringAsymmetry effect;
  return effect;
}

}  // namespace searig::estimator
