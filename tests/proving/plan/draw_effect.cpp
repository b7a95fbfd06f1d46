#include "tests/proving/plan/draw_effect.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "tests/proving/plan/draw_oddity.h"

namespace searig::proving {
namespace {

constexpr double share = 0.03;  // of the torque, before the strength is calibrated
constexpr double turn = 2.0 * std::numbers::pi;
using Strings = std::vector<std::string>;

Effect spring_effect(const std::string& name, const Statistics& s, Random& r) {
  const double torque = share * s.torque_rms_nm;
  if (name == "spring.viscous") {
    if (r.chance(0.7))
      return {name,
              "newton",
              {{"c_nm_s_per_rad", torque / s.rate_rms_rad_s}},
              {"c_nm_s_per_rad"},
              {"c_nm_s_per_rad"}};
    return {name,
            "dashpot_behind_stiff_spring",
            {{"c_nm_s_per_rad", torque / s.rate_rms_rad_s}, {"tau_s", r.uniform(8e-4, 2e-3)}},
            {"c_nm_s_per_rad"},
            {"c_nm_s_per_rad"}};
  }
  if (name == "spring.cubic") {
    if (r.chance(0.5))
      return {name,
              "polynomial",
              {{"k3_nm_per_rad3", r.sign() * torque / std::pow(s.deflection_rms_rad, 3)}},
              {"k3_nm_per_rad3"},
              {"k3_nm_per_rad3"}};
    return {name,
            "sinh",
            {{"torque_nm", r.sign() * torque},
             {"scale_rad", r.uniform(0.5, 0.8) * s.deflection_peak_rad}},
            {"torque_nm"},
            {}};
  }
  if (name == "spring.hysteresis") {
    const std::string form = r.pick(Strings{"maxwell_slip", "bouc_wen", "preisach"});
    const double yield = r.uniform(0.15, 0.45) * s.deflection_rms_rad;
    Effect e{
        name, form, {{"torque_nm", torque}, {"yield_rad", yield}}, {"torque_nm"}, {"torque_nm"}};
    if (form == "maxwell_slip") e.parameters["spread"] = r.uniform(0.3, 0.9);
    if (form == "bouc_wen")
      e.parameters["beta"] = r.uniform(0.4, 0.65), e.parameters["exponent"] = r.uniform(1.0, 1.8);
    if (form == "preisach")
      e.parameters["reach_rad"] = 1.3 * s.deflection_peak_rad, e.comparable.clear();
    return e;
  }
  if (name == "spring.relaxation") {
    const double k = torque / s.deflection_rms_rad;
    if (r.chance(0.25))
      return {name,
              "springpot",
              {{"k1_nm_per_rad", k}, {"exponent", r.uniform(0.1, 0.3)}},
              {"k1_nm_per_rad"},
              {}};
    Effect e{name,
             "prony",
             {{"k1_nm_per_rad", k}, {"tau_s", r.log_uniform(0.3, 4.0)}},
             {"k1_nm_per_rad"},
             {}};
    if (r.chance(0.5)) {
      e.comparable = {"k1_nm_per_rad", "tau_s"};
      return e;
    }
    e.parameters["k2_nm_per_rad"] = 0.8 * k, e.parameters["tau2_s"] = 6.0 * e.at("tau_s");
    e.amplitude.push_back("k2_nm_per_rad");
    if (r.chance(0.4)) {
      e.parameters["k3_nm_per_rad"] = 0.8 * k, e.parameters["tau3_s"] = e.at("tau_s") / 6.0;
      e.amplitude.push_back("k3_nm_per_rad");
    }
    return e;
  }
  if (name == "spring.mullins") {
    if (r.chance(0.5))
      return {name,
              "ogden_roxburgh",
              {{"share", 2 * share},
               {"energy_j", r.uniform(0.3, 0.8) * 0.5 * s.torque_peak_nm * s.deflection_peak_rad}},
              {"share"},
              {}};
    return {name,
            "largest_deflection",
            {{"share", 2 * share}, {"scale_rad", r.uniform(0.3, 0.7) * s.deflection_peak_rad}},
            {"share"},
            {}};
  }
  if (name == "spring.temperature")
    return {name,
            r.chance(0.5) ? "linear" : "exponential",
            {{"per_c", -3.0 * share / std::max(0.5, s.spring_span_c)}, {"reference_c", 25.0}},
            {"per_c"},
            {"per_c"}};
  if (name == "spring.asymmetry")
    return {name,
            "smooth",
            {{"share", r.sign() * 2 * share},
             {"blend_rad", r.uniform(0.02, 0.1) * s.deflection_rms_rad}},
            {"share"},
            {"share"}};
  if (name == "spring.deadzone")
    return {name,
            "soft_edges",
            {{"half_width_rad", 0.05 * s.deflection_rms_rad}, {"edge_share", r.uniform(0.03, 0.2)}},
            {"half_width_rad"},
            {"half_width_rad"}};
  throw std::invalid_argument("no spring effect is called " + name);
}

Effect drive_effect(const std::string& name, const Rig& rig, const Statistics& s, Random& r) {
  const Baseline& b = rig.base;
  const double torque = share * s.torque_rms_nm;
  if (name == "drive.coulomb")
    return {name, "baseline", {{"torque_nm", b.coulomb_nm}}, {"torque_nm"}, {"torque_nm"}};
  if (name == "drive.viscous")
    return {name,
            "baseline",
            {{"b_nm_s_per_rad", b.viscous_nm_s_per_rad}},
            {"b_nm_s_per_rad"},
            {"b_nm_s_per_rad"}};
  if (name == "drive.inertia")
    return {name, "baseline", {{"j_kg_m2", b.inertia_kg_m2}}, {"j_kg_m2"}, {"j_kg_m2"}};
  if (name == "drive.stribeck") {
    const std::string form =
        r.pick(Strings{"gaussian", "exponential", "lorentzian", "square_root"});
    Effect e{name,
             form,
             {{"torque_nm", 2 * torque},
              {"velocity_rad_s", r.uniform(0.2, 0.55) * s.velocity_rms_rad_s}},
             {"torque_nm"},
             {}};
    if (form == "gaussian") e.comparable = {"torque_nm", "velocity_rad_s"};
    return e;
  }
  if (name == "drive.load_friction") {
    Effect e{name, "equal_shares", {{"share", 2 * share}}, {"share"}, {"share"}};
    if (r.chance(0.5)) return e;
    e.form = "different_shares",
    e.parameters["share_back_driving"] = r.uniform(0.4, 1.6) * e.at("share");
    e.amplitude.push_back("share_back_driving"), e.comparable.clear();
    return e;
  }
  if (name == "drive.ripple") {
    Effect e{name,
             "one_harmonic",
             {{"torque_nm", torque},
              {"cycles_per_rad", r.log_uniform(8.0, 40.0)},
              {"phase_rad", r.uniform(0.0, turn)}},
             {"torque_nm"},
             {"torque_nm", "cycles_per_rad"}};
    if (r.chance(0.5)) return e;
    e.form = "two_harmonics";
    e.parameters["second_harmonic_share"] = r.uniform(0.15, 0.4),
    e.parameters["second_phase_rad"] = r.uniform(0.0, turn);
    return e;
  }
  if (name == "drive.current_offset")
    return {name,
            "constant",
            {{"offset_a", r.sign() * share * s.current_rms_a}},
            {"offset_a"},
            {"offset_a"}};
  if (name == "drive.torque_constant_temperature")
    return {name,
            "linear",
            {{"per_c", -4.0 * share / std::max(1.0, s.winding_span_c)}, {"reference_c", 25.0}},
            {"per_c"},
            {"per_c"}};
  throw std::invalid_argument("no drive effect is called " + name);
}

Effect rig_effect(const std::string& name, const Rig& rig, const Statistics& s, Random& r) {
  const double torque = share * s.torque_rms_nm;
  if (name == "rig.delay") return {name, "pure", {{"delay_s", 0.015}}, {"delay_s"}, {"delay_s"}};
  if (name == "rig.lag") {
    const std::string form = r.pick(Strings{"first_order", "critically_damped", "moving_average"});
    return {name,
            form,
            {{"tau_s", 0.015}},
            {"tau_s"},
            form == "first_order" ? Strings{"tau_s"} : Strings{}};
  }
  if (name == "rig.zero_drift") {
    Effect e{name,
             "linear",
             {{"nm_per_min", r.sign() * 3 * torque * 60.0 / rig.duration_s}},
             {"nm_per_min"},
             {"nm_per_min"}};
    if (r.chance(0.6)) return e;
    e.form = "settling", e.parameters["settles_s"] = 1.5 * rig.duration_s, e.comparable.clear();
    return e;
  }
  if (name == "rig.gravity")
    return {name,
            "pendulum",
            {{"torque_nm", 2 * torque}, {"phase_rad", r.uniform(-1.2, 1.2)}},
            {"torque_nm"},
            {"torque_nm"}};
  if (name == "rig.inertia")
    return {name,
            "rigid",
            {{"j_kg_m2", torque / s.output_acceleration_rms_rad_s2}},
            {"j_kg_m2"},
            {"j_kg_m2"}};
  throw std::invalid_argument("no rig effect is called " + name);
}

}  // namespace

Effect draw_effect(const std::string& name, const Rig& rig, const Statistics& stats,
                   Random random) {
  if (name.starts_with("spring.")) return spring_effect(name, stats, random);
  if (name.starts_with("drive.")) return drive_effect(name, rig, stats, random);
  if (name.starts_with("rig.")) return rig_effect(name, rig, stats, random);
  return draw_oddity(name, rig, stats, random);
}

void give(Rig& rig, const Effect& e) {
  if (e.name == "drive.coulomb")
    rig.base.coulomb_nm = e.at("torque_nm");
  else if (e.name == "drive.viscous")
    rig.base.viscous_nm_s_per_rad = e.at("b_nm_s_per_rad");
  else if (e.name == "drive.inertia")
    rig.base.inertia_kg_m2 = e.at("j_kg_m2");
  else
    rig.effects.push_back(e);
}

}  // namespace searig::proving
