#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

class SpringCubic final : public SingleAmplitude {
 public:
  SpringCubic()
      : SingleAmplitude(
            {.name = "spring.cubic",
             .path = Path::spring,
             .title = "the spring stiffens or softens as it is deflected further",
             .equation = "+ k3*theta^3",
             .looks_like = "the same bend at every speed, no loop",
             .confused_with = "spring.deadzone, spring.asymmetry, a wave in the output encoder",
             .separated_by =
                 "a slow staircase of amplitudes, then the output mounted 90 degrees further",
             .channel = "deflection_rad",
             .source = "Duffing form; I. Kovacic, M. Brennan, The Duffing Equation, 2011"},
            {{"k3_nm_per_rad3", -unlimited, unlimited, "cubic stiffness"}}) {}

  bool applies(const Motion& m) const override { return m.has_spring(); }

 protected:
  Eigen::VectorXd column(const Motion& m, std::span<const double>) const override {
    return as_array(m.theta).cube().matrix();
  }
};

}  // namespace

const Effect& spring_cubic() {
  static const SpringCubic effect;
  return effect;
}

}  // namespace searig::estimator
