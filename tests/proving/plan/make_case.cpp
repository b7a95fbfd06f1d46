#include "tests/proving/plan/make_case.h"

#include <algorithm>
#include <cmath>

namespace searig::proving {
namespace {

/// The host cannot know the shortest way of a serial adapter: the clocks' map is open by this much.
constexpr double clock_slack_s = 3e-3;

struct Band {
  double low, high;
};

Band band_of(Strength strength) {
  switch (strength) {
    case Strength::faint:
      return {0.12, 0.28};
    case Strength::weak:
      return {0.35, 0.9};
    case Strength::medium:
      return {1.2, 2.7};
    case Strength::strong:
      return {3.3, 10.0};
    default:
      return {1.6, 6.0};
  }
}

/// What comes late shows only beyond the clock's slack: it is drawn in seconds.
bool comes_late(const Effect& e) {
  return e.name == "rig.delay" || e.name == "rig.lag";
}

double draw_lateness_s(Strength strength, Random& random) {
  if (strength == Strength::weak) return random.uniform(0.008, 0.012);
  if (strength == Strength::strong) return random.uniform(0.026, 0.06);
  return random.uniform(0.014, 0.024);
}

struct Shown {
  Recording recording;
  Reachable reachable;
  double visible;
};

Shown show(const Rig& rig, const Sensing& sensing, const Concealed& hidden) {
  const Trace trace = simulate(rig);
  Shown s{observe(trace, rig, sensing), {}, 0.0};
  s.reachable = reachable(trace, rig, sensing, s.recording, hidden);
  s.visible = visible_strength(trace, rig, s.recording, hidden, s.reachable, clock_slack_s);
  return s;
}

/// Largest amplitudes that still are the effect and not a broken rig.
void keep_physical(Effect& e, const Statistics& stats) {
  const auto limit = [&](const char* key, double most) {
    if (const auto p = e.parameters.find(key); p != e.parameters.end())
      p->second = std::clamp(p->second, -most, most);
  };
  limit("share", 0.45), limit("share_back_driving", 0.45);
  limit("half_width_rad", 0.6 * stats.deflection_rms_rad);
  if (is_nameless(e)) limit("torque_nm", stats.torque_rms_nm);
  limit("depth_share", 0.8), limit("set_rad", stats.deflection_rms_rad);
  if (e.name == "spring.temperature" || e.name == "drive.torque_constant_temperature")
    limit("per_c", 0.02);
  if (e.name == "drive.stribeck") limit("torque_nm", 0.4 * stats.torque_rms_nm);
  if (e.name == "drive.inertia") e.parameters["j_kg_m2"] = std::max(e.at("j_kg_m2"), 1e-7);
}

/// Alone in the rig, the effect is made as visible as wanted: a few secant-free rescalings, since
/// nearly every effect grows in proportion to its amplitude.
Effect calibrate(Effect e, const Rig& plain, const Sensing& sensing, const Statistics& stats,
                 double wanted) {
  for (int i = 0; i < 7; ++i) {
    Rig rig = plain;
    keep_physical(e, stats);
    give(rig, e);
    const double now = show(rig, sensing, Concealed::from({e})).visible;
    if (std::abs(now / wanted - 1.0) < 0.08 || e.amplitude.empty()) break;
    e.scale(std::clamp(wanted / std::max(now, 1e-3), 0.1, 8.0));
  }
  keep_physical(e, stats);
  return e;
}

/// c = k*lateness: at the load cell the damper looks like nothing at all (notes, section 2.2).
void compensate(Effect& viscous, const Effect& late, const Baseline& base) {
  viscous.parameters["c_nm_s_per_rad"] =
      base.stiffness_nm_per_rad * late.parameters.at(late.amplitude[0]);
}

double off_by(Random& random, double most) {
  return 1.0 + random.uniform(-most, most);
}

/// The numbers in the owner's model: true, somewhat off, or fitted with the effect in.
Baseline believed_numbers(const Item& item, const Rig& rig, const FittedNumbers& fitted,
                          Random random) {
  Baseline b = rig.base;
  const std::string& v = item.variant;
  if (v == "adapted") {
    b.stiffness_nm_per_rad = fitted.stiffness_nm_per_rad;
    b.torque_constant_nm_per_a = fitted.torque_constant_nm_per_a;
    b.inertia_kg_m2 = std::max(0.1 * b.inertia_kg_m2, fitted.inertia_kg_m2);
    b.coulomb_nm = std::max(0.1 * b.coulomb_nm, fitted.coulomb_nm);
    b.viscous_nm_s_per_rad = std::max(0.1 * b.viscous_nm_s_per_rad, fitted.viscous_nm_s_per_rad);
    return b;
  }
  const bool every = v == "every number" ||
                     (item.level != "exact" && item.level != "numbers" && random.chance(0.7));
  if (every || v == "stiffness") b.stiffness_nm_per_rad *= off_by(random, 0.12);
  if (every || v == "torque constant") b.torque_constant_nm_per_a *= off_by(random, 0.12);
  if (every) b.inertia_kg_m2 *= off_by(random, 0.12);
  if (every) b.coulomb_nm *= off_by(random, 0.12);
  if (every) b.viscous_nm_s_per_rad *= off_by(random, 0.12);
  return b;
}

Case attempt(const Item& item, const Random& random) {
  Case c{item, draw_rig(item, random.fork("rig")), {}, {}, {}, {}, {}, 0.0, {}};
  const Statistics stats = statistics_of(simulate(c.rig), c.rig);
  c.sensing = draw_sensing(item, c.rig, stats, random.fork("sensing"));
  Random strength = random.fork("strength");
  for (const auto& name : item.effects) {
    Effect e = draw_effect(name, c.rig, stats, random.fork(name));
    const Band band = band_of(item.strength);
    const double wanted = strength.log_uniform(band.low, band.high);
    if (comes_late(e))
      e.parameters[e.amplitude[0]] = draw_lateness_s(item.strength, strength);
    else
      e = calibrate(e, c.rig, c.sensing, stats, wanted);
    c.concealed.push_back(e);
  }
  if (item.variant == "compensating") compensate(c.concealed[0], c.concealed[1], c.rig.base);
  for (const auto& e : c.concealed) give(c.rig, e);
  Shown shown = show(c.rig, c.sensing, Concealed::from(c.concealed));
  c.recording = std::move(shown.recording);
  c.reachable = shown.reachable;
  c.visible = shown.visible;
  c.believed = believed_numbers(item, c.rig, c.reachable.fitted, random.fork("believed"));
  c.located = locate(c.rig, item.variant);
  return c;
}

/// Some friction makes some rigs chatter, and then nothing can be seen in the current any more.
bool is_calm(const Case& c) {
  return c.reachable.spring.after < 0.03 * c.sensing.torque_rms_nm &&
         c.reachable.drive.after < 0.06 * c.sensing.torque_rms_nm &&
         c.reachable.drive.after < 6.0 * c.reachable.spring.after;
}

/// A null must be one, and an effect as strong as the stratum says; not every rig can show it.
bool as_wanted(const Case& c) {
  if (!std::isfinite(c.visible) || !std::isfinite(c.reachable.rho()) || !is_calm(c)) return false;
  if (c.concealed.empty()) return c.visible < 0.08;
  if (c.concealed.size() > 1 || comes_late(c.concealed[0])) return true;
  if (c.concealed[0].amplitude.empty()) return c.visible > 1.0;
  const Band band = band_of(c.item.strength);
  return c.visible > 0.85 * band.low && c.visible < 1.15 * band.high;
}

}  // namespace

Case make_case(const Item& item) {
  const Random random(item.seed);
  Case c = attempt(item, random.fork("attempt 0"));
  for (int i = 1; i < 12 && !as_wanted(c); ++i)
    c = attempt(item, random.fork("attempt " + std::to_string(i)));
  return c;
}

}  // namespace searig::proving
