#include "tests/proving/rig/drive.h"

#include <cmath>
#include <stdexcept>

namespace searig::proving {
namespace {

/// How the breakaway surplus dies away with speed: Bo & Pavelescu's exponents and Hess & Soom's
/// Lorentzian.
double stribeck_shape(const std::string& form, double x) {
  if (form == "gaussian") return std::exp(-x * x);
  if (form == "exponential") return std::exp(-x);
  if (form == "lorentzian") return 1.0 / (1.0 + x * x);
  if (form == "square_root") return std::exp(-std::sqrt(x));
  throw std::invalid_argument("no Stribeck curve has the form " + form);
}

/// LuGre (Canudas de Wit 1995) without its micro-damping: bristles carry what the curve allows.
class Stribeck final : public Torque {
 public:
  Stribeck(const Effect& e, double width_rad)
      : form_(e.form),
        torque_nm_(e.at("torque_nm")),
        speed_(e.at("velocity_rad_s")),
        slip_(width_rad) {}

  double advance(const Instant& now, double dt) override {
    const double w = now.input_velocity_rad_s;
    return -torque_nm_ * stribeck_shape(form_, std::abs(w) / speed_) * slip_.advance(w, dt);
  }

 private:
  std::string form_;
  double torque_nm_, speed_;
  Slip slip_;
};

class DryFriction final : public Torque {
 public:
  DryFriction(double torque_nm, double width_rad) : torque_nm_(torque_nm), slip_(width_rad) {}
  double advance(const Instant& now, double dt) override {
    return -torque_nm_ * slip_.advance(now.input_velocity_rad_s, dt);
  }

 private:
  double torque_nm_;
  Slip slip_;
};

/// Tooth friction grows with the torque the teeth carry; back-driving may cost another share.
class LoadFriction final : public Torque {
 public:
  LoadFriction(const Effect& e, double width_rad)
      : driving_(e.at("share")),
        back_(e.at_or("share_back_driving", e.at("share"))),
        slip_(width_rad) {}

  double advance(const Instant& now, double dt) override {
    const double torque = now.spring_torque_nm;
    const double slip = slip_.advance(now.input_velocity_rad_s, dt);
    const double share = torque * slip > 0.0 ? driving_ : back_;
    return -share * std::abs(torque) * slip;
  }

 private:
  double driving_, back_;
  Slip slip_;
};

std::unique_ptr<Torque> ripple(const Effect& e) {
  const double a = e.at("torque_nm"), n = e.at("cycles_per_rad"), phase = e.at("phase_rad");
  const double second = e.at_or("second_harmonic_share", 0.0),
               phase2 = e.at_or("second_phase_rad", 0.0);
  return formulated([=](const Instant& x) {
    const double angle = n * x.input_angle_rad + phase;
    return -a * (std::sin(angle) + second * std::sin(2.0 * angle + phase2));
  });
}

/// Magnets weaken as they warm: efficiency*torque_constant*(per_c*(T - reference))*I.
std::unique_ptr<Torque> magnet_temperature(const Effect& e, const Baseline& base) {
  const double gain = base.efficiency * base.torque_constant_nm_per_a * e.at("per_c");
  return formulated([=, reference = e.at("reference_c")](const Instant& x) {
    return gain * (x.winding_c - reference) * x.current_a;
  });
}

}  // namespace

double Slip::advance(double velocity, double dt_s) {
  const double towards = velocity >= 0.0 ? 1.0 : -1.0;
  state_ = towards + (state_ - towards) * std::exp(-std::abs(velocity) * dt_s / width_rad_);
  return state_;
}

std::unique_ptr<Torque> make_coulomb(const Baseline& base) {
  return std::make_unique<DryFriction>(base.coulomb_nm, base.bristle_rad);
}

std::unique_ptr<Torque> make_drive_torque(const Effect& e, const Baseline& base) {
  if (e.name == "drive.stribeck") return std::make_unique<Stribeck>(e, base.bristle_rad);
  if (e.name == "drive.load_friction") return std::make_unique<LoadFriction>(e, base.bristle_rad);
  if (e.name == "drive.ripple") return ripple(e);
  if (e.name == "drive.torque_constant_temperature") return magnet_temperature(e, base);
  return nullptr;
}

}  // namespace searig::proving
