#include "tests/proving/rig/oddity.h"

#include <algorithm>
#include <cmath>

#include "tests/proving/rig/drive.h"

namespace searig::proving {
namespace {

double bump(double x, double centre, double width) {
  const double u = (x - centre) / width;
  return std::exp(-0.5 * u * u);
}

bool within(double t, const Effect& e) {
  return t >= e.at("from_s") && t <= e.at("to_s");
}

/// Each time the torque changes sign the teeth cross their gap and hit: a short blow.
class BacklashClick final : public Torque {
 public:
  BacklashClick(double torque_nm, double lasts_s) : torque_nm_(torque_nm), lasts_s_(lasts_s) {}
  double advance(const Instant& now, double) override {
    const double side = now.linear_torque_nm >= 0.0 ? 1.0 : -1.0;
    if (side != side_ && now.t_s - hit_s_ > 4.0 * lasts_s_) hit_s_ = now.t_s;
    side_ = side;
    const double since = (now.t_s - hit_s_) / lasts_s_;
    return since < 8.0 ? -torque_nm_ * side * since * std::exp(1.0 - since) : 0.0;
  }

 private:
  double torque_nm_, lasts_s_, side_ = 1.0, hit_s_ = -1e9;
};

/// Dry friction that comes and goes.
class SlipEvent final : public Torque {
 public:
  SlipEvent(const Effect& e, double width_rad) : e_(e), slip_(width_rad) {}
  double advance(const Instant& now, double dt) override {
    const double slip = slip_.advance(now.input_velocity_rad_s, dt);
    return within(now.t_s, e_) ? -e_.at("torque_nm") * slip : 0.0;
  }

 private:
  Effect e_;
  Slip slip_;
};

}  // namespace

std::unique_ptr<Torque> make_odd_spring(const Effect& e, const Baseline& base) {
  const double k = base.stiffness_nm_per_rad;
  if (e.form == "detent")  // a notch in the spring's own guide
    return formulated([a = e.at("torque_nm"), at = e.at("centre_rad"), w = e.at("width_rad")](
                          const Instant& x) { return a * bump(x.deflection_rad, at, w); });
  if (e.form == "periodic_bearing_friction")  // a bent shaft drags once per n-th of a turn
    return formulated([a = e.at("torque_nm"), n = e.at("cycles_per_rad"),
                       s = e.at("smoothing_rad_s")](const Instant& x) {
      return a * std::sin(n * x.output_angle_rad) * std::tanh(x.deflection_rate_rad_s / s);
    });
  if (e.form == "plastic_yield")  // the spring takes a permanent set at one instant
    return formulated([k, set = e.at("set_rad"), from = e.at("from_s")](const Instant& x) {
      return x.t_s >= from ? -k * set : 0.0;
    });
  return nullptr;
}

std::unique_ptr<Torque> make_odd_drive(const Effect& e, const Baseline& base) {
  if (e.form == "snag")  // one tooth is damaged: felt at one angle, in one direction
    return formulated(
        [a = e.at("torque_nm"), at = e.at("centre_rad"), w = e.at("width_rad")](const Instant& x) {
          return x.input_velocity_rad_s > 0.0 ? -a * bump(x.input_angle_rad, at, w) : 0.0;
        });
  if (e.form == "quadratic_drag")
    return formulated([c = e.at("nm_s2_per_rad2")](const Instant& x) {
      return -c * x.input_velocity_rad_s * std::abs(x.input_velocity_rad_s);
    });
  if (e.form == "speed_chatter")  // a resonance of the housing in one band of speed
    return formulated([a = e.at("torque_nm"), v = e.at("centre_rad_s"),
                       w = e.at("width_rad_s")](const Instant& x) {
      return -a * bump(std::abs(x.input_velocity_rad_s), v, w) *
             (x.input_velocity_rad_s > 0 ? 1 : -1);
    });
  if (e.form == "backlash_click")
    return std::make_unique<BacklashClick>(e.at("torque_nm"), e.at("lasts_s"));
  if (e.form == "slip_event") return std::make_unique<SlipEvent>(e, base.bristle_rad);
  return nullptr;
}

void apply_odd_sensor(const Effect& e, ModuleReading& r) {
  if (e.form == "encoder_eccentricity")
    r.input_angle_rad += e.at("amplitude_rad") *
                         std::sin(e.at("cycles_per_rad") * r.input_angle_rad + e.at("phase_rad"));
  if (e.form == "encoder_slip" && r.t_s >= e.at("from_s")) r.input_angle_rad += e.at("jump_rad");
  if (e.form == "current_sensor_fault" && within(r.t_s, e)) r.current_a *= 1.0 - e.at("share");
}

}  // namespace searig::proving
