#include "tests/proving/rig/spring.h"

#include <cmath>

#include "tests/proving/rig/hysteresis.h"
#include "tests/proving/rig/mullins.h"
#include "tests/proving/rig/viscoelastic.h"

namespace searig::proving {
namespace {

std::unique_ptr<Torque> viscous(const Effect& e) {
  const double c = e.at("c_nm_s_per_rad");
  if (e.form == "newton")
    return formulated([=](const Instant& x) { return c * x.deflection_rate_rad_s; });
  return make_maxwell_branches(
      {{c / e.at("tau_s"), e.at("tau_s")}});  // a dashpot behind a stiff spring
}

std::unique_ptr<Torque> cubic(const Effect& e) {
  if (e.form == "polynomial")
    return formulated([k3 = e.at("k3_nm_per_rad3")](const Instant& x) {
      return k3 * x.deflection_rad * x.deflection_rad * x.deflection_rad;
    });
  // Langevin-like chains: A*(sinh(x) - x) = A*x^3/6 + A*x^5/120...
  return formulated([a = e.at("torque_nm"), scale = e.at("scale_rad")](const Instant& now) {
    const double x = now.deflection_rad / scale;
    return a * (std::sinh(x) - x);
  });
}

double softplus(double x) {
  return x > 30.0 ? x : std::log1p(std::exp(x));
}

/// Play whose flanks meet softly: what the spring feels is theta outside +-h, rounded over s.
std::unique_ptr<Torque> deadzone(const Effect& e, double k) {
  return formulated([k, h = e.at("half_width_rad"), edge = e.at("edge_share")](const Instant& x) {
    const double s = edge * h;
    const double felt =
        s * (softplus((x.deflection_rad - h) / s) - softplus((-x.deflection_rad - h) / s));
    return k * (felt - x.deflection_rad);
  });
}

std::unique_ptr<Torque> temperature(const Effect& e, double k) {
  const double alpha = e.at("per_c"), reference = e.at("reference_c");
  const bool arrhenius = e.form == "exponential";
  return formulated([=](const Instant& x) {
    const double warmer = alpha * (x.spring_c - reference);
    return k * x.deflection_rad * (arrhenius ? std::expm1(warmer) : warmer);
  });
}

/// (share/2)*k*theta*tanh(theta/s): the two stiffnesses blend through zero.
std::unique_ptr<Torque> asymmetry(const Effect& e, double k) {
  return formulated([k, share = e.at("share"), s = e.at("blend_rad")](const Instant& x) {
    return 0.5 * share * k * x.deflection_rad * std::tanh(x.deflection_rad / s);
  });
}

}  // namespace

std::unique_ptr<Torque> make_spring_torque(const Effect& e, const Baseline& base) {
  const double k = base.stiffness_nm_per_rad;
  if (e.name == "spring.viscous") return viscous(e);
  if (e.name == "spring.cubic") return cubic(e);
  if (e.name == "spring.hysteresis") return make_hysteresis(e);
  if (e.name == "spring.relaxation") return make_relaxation(e);
  if (e.name == "spring.mullins") return make_mullins(e, k);
  if (e.name == "spring.temperature") return temperature(e, k);
  if (e.name == "spring.asymmetry") return asymmetry(e, k);
  if (e.name == "spring.deadzone") return deadzone(e, k);
  return nullptr;
}

}  // namespace searig::proving
