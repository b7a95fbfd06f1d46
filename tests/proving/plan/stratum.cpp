#include "tests/proving/plan/stratum.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <stdexcept>

#include "tests/proving/random.h"

namespace searig::proving {
namespace {

using Names = std::vector<std::string>;

const Names singles{"spring.viscous",
                    "spring.cubic",
                    "spring.hysteresis",
                    "spring.relaxation",
                    "spring.mullins",
                    "spring.temperature",
                    "spring.asymmetry",
                    "spring.deadzone",
                    "drive.inertia",
                    "drive.coulomb",
                    "drive.viscous",
                    "drive.stribeck",
                    "drive.load_friction",
                    "drive.ripple",
                    "drive.current_offset",
                    "drive.torque_constant_temperature",
                    "rig.delay",
                    "rig.lag",
                    "rig.zero_drift",
                    "rig.gravity",
                    "rig.inertia"};

const Names oddities{"snag",
                     "quadratic_drag",
                     "speed_chatter",
                     "backlash_click",
                     "slip_event",
                     "detent",
                     "periodic_bearing_friction",
                     "plastic_yield",
                     "zero_random_walk",
                     "frozen_reading",
                     "zero_step",
                     "saturation",
                     "gain_fault",
                     "cable_tremor",
                     "missing_codes",
                     "encoder_eccentricity",
                     "encoder_slip",
                     "current_sensor_fault"};

/// Those that hide each other first; the rest are ordinary company.
const std::vector<Names> pairs{{"spring.viscous", "rig.delay"},
                               {"spring.viscous", "rig.lag"},
                               {"drive.viscous", "rig.delay"},
                               {"spring.relaxation", "spring.hysteresis"},
                               {"spring.cubic", "spring.deadzone"},
                               {"spring.mullins", "spring.temperature"},
                               {"spring.relaxation", "rig.zero_drift"},
                               {"drive.coulomb", "drive.stribeck"},
                               {"drive.coulomb", "drive.viscous"},
                               {"rig.inertia", "rig.lag"},
                               {"rig.gravity", "spring.asymmetry"},
                               {"drive.load_friction", "drive.coulomb"},
                               {"spring.viscous", "drive.stribeck"},
                               {"rig.gravity", "spring.cubic"},
                               {"spring.hysteresis", "drive.ripple"},
                               {"spring.temperature", "drive.torque_constant_temperature"},
                               {"spring.viscous", "spring.hysteresis"},
                               {"rig.zero_drift", "drive.current_offset"},
                               {"spring.relaxation", "rig.gravity"},
                               {"drive.inertia", "rig.inertia"},
                               {"spring.deadzone", "drive.load_friction"},
                               {"spring.asymmetry", "drive.viscous"},
                               {"spring.cubic", "rig.delay"},
                               {"spring.mullins", "drive.stribeck"},
                               {"drive.ripple", "rig.inertia"},
                               {"spring.hysteresis", "rig.lag"},
                               {"spring.temperature", "rig.zero_drift"},
                               {"drive.current_offset", "spring.deadzone"},
                               {"spring.relaxation", "drive.load_friction"},
                               {"drive.inertia", "spring.viscous"}};

const std::vector<Names> triples{
    {"spring.viscous", "rig.delay", "drive.viscous"},
    {"spring.viscous", "spring.hysteresis", "rig.lag"},
    {"spring.relaxation", "rig.zero_drift", "spring.temperature"},
    {"drive.coulomb", "drive.stribeck", "drive.load_friction"},
    {"spring.cubic", "spring.deadzone", "rig.gravity"},
    {"rig.gravity", "rig.inertia", "drive.ripple"},
    {"spring.hysteresis", "drive.current_offset", "rig.gravity"},
    {"spring.mullins", "drive.stribeck", "rig.delay"},
    {"spring.asymmetry", "spring.viscous", "drive.inertia"},
    {"spring.relaxation", "drive.load_friction", "rig.inertia"},
    {"spring.temperature", "drive.torque_constant_temperature", "spring.cubic"},
    {"spring.deadzone", "drive.viscous", "rig.zero_drift"}};

/// Excitation that cannot tell much apart.
const std::vector<std::pair<std::string, Names>> poor{
    {"slow_triangle",
     {"spring.viscous", "drive.coulomb", "spring.hysteresis", "rig.delay", "drive.viscous",
      "rig.zero_drift", "spring.cubic", "drive.load_friction"}},
    {"sine",
     {"spring.viscous", "drive.viscous", "drive.inertia", "spring.relaxation", "rig.lag",
      "rig.inertia", "spring.hysteresis", "drive.coulomb"}},
    {"constant_speed",
     {"drive.coulomb", "drive.viscous", "spring.viscous", "drive.load_friction", "spring.asymmetry",
      "rig.gravity", "rig.zero_drift", "spring.relaxation"}}};

/// "adapted": the owner's numbers were fitted with the effect in. Otherwise the regime in which
/// alone it shows.
const std::vector<std::pair<std::string, std::string>> masked{
    {"adapted", "spring.relaxation"},
    {"adapted", "spring.temperature"},
    {"adapted", "spring.mullins"},
    {"adapted", "spring.viscous"},
    {"adapted", "spring.cubic"},
    {"adapted", "spring.hysteresis"},
    {"adapted", "spring.asymmetry"},
    {"adapted", "drive.load_friction"},
    {"adapted", "drive.viscous"},
    {"adapted", "rig.gravity"},
    {"rare zero crossing", "spring.deadzone"},
    {"rare zero crossing", "spring.asymmetry"},
    {"one fast burst", "drive.inertia"},
    {"one fast burst", "spring.viscous"},
    {"one fast burst", "rig.inertia"},
    {"one fast burst", "rig.lag"},
    {"one large burst", "spring.cubic"},
    {"one large burst", "spring.mullins"},
    {"one slow stretch", "drive.stribeck"},
    {"one slow stretch", "drive.ripple"}};

void add(std::vector<Item>& items, int copies, const Item& like) {
  for (int i = 0; i < copies; ++i) items.push_back(like);
}

std::vector<Item> list_all() {
  std::vector<Item> all;
  add(all, 50, {"", "null exact", "exact", "", {}, Strength::none, 0});
  for (const char* wrong : {"stiffness", "torque constant", "load-cell offset", "deflection offset",
                            "initial state", "every number"})
    add(all, 10, {"", "null numbers", "numbers", wrong, {}, Strength::none, 0});
  for (const auto& effect : singles) {
    add(all, 2, {"", "single strong", "single", "", {effect}, Strength::strong, 0});
    add(all, 2, {"", "single medium", "single", "", {effect}, Strength::medium, 0});
    add(all, 2, {"", "single weak", "single", "", {effect}, Strength::weak, 0});
    if (effect.starts_with("spring") || effect == "rig.gravity" || effect == "drive.coulomb")
      add(all, 1, {"", "single faint", "single", "", {effect}, Strength::faint, 0});
  }
  for (const auto& [motion, effects] : poor)
    for (const auto& effect : effects)
      add(all, 1, {"", "poor", "poor", motion, {effect}, Strength::medium, 0});
  for (const auto& effects : pairs)
    add(all, 1, {"", "pair", "pair", "", effects, Strength::obvious, 0});
  for (const char* late : {"rig.delay", "rig.lag"})
    add(all, 2,
        {"", "pair", "pair", "compensating", {"spring.viscous", late}, Strength::obvious, 0});
  for (const auto& effects : triples)
    add(all, 1, {"", "triple", "triple", "", effects, Strength::obvious, 0});
  for (const auto& [variant, effect] : masked)
    add(all, 1, {"", "masked", "rare", variant, {effect}, Strength::obvious, 0});
  for (const auto& oddity : oddities)
    add(all, 2, {"", "nameless", "strange", "", {oddity}, Strength::obvious, 0});
  return all;
}

}  // namespace

std::vector<Item> plan_full(std::uint64_t seed) {
  std::vector<Item> all = list_all();
  Random random = Random(seed).fork("plan");
  for (auto& item : all) item.seed = random.bits();
  for (std::size_t i = all.size(); i > 1; --i)
    std::swap(all[i - 1],
              all[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
  for (std::size_t i = 0; i < all.size(); ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "p%04zu", i);
    all[i].name = name;
  }
  return all;
}

std::vector<Item> plan_set(const std::string& set, std::uint64_t seed, int count) {
  const std::vector<Item> all = plan_full(seed);
  std::map<std::string, int> size, taken;
  for (const auto& item : all) ++size[item.stratum];
  if (set != "full" && set != "small" && !size.contains(set))
    throw std::invalid_argument("no set or stratum is called '" + set + "'");
  std::vector<Item> chosen;
  for (const auto& item : all) {
    if (set == "small" && taken[item.stratum]++ * 6 >= size[item.stratum]) continue;
    if (set != "small" && set != "full" && item.stratum != set) continue;
    if (count > 0 && static_cast<int>(chosen.size()) >= count) break;
    chosen.push_back(item);
  }
  return chosen;
}

}  // namespace searig::proving
