#include "tests/proving/truth/write.h"

namespace searig::proving {
namespace {

using nlohmann::json;

json truth_of(const Case& c) {
  const Baseline& b = c.rig.base;
  json truth = {{"spring.linear.k_nm_per_rad", b.stiffness_nm_per_rad},
                {"drive.motor.torque_constant_nm_per_a", b.torque_constant_nm_per_a},
                {"drive.motor.efficiency", b.efficiency},
                {"drive.inertia.j_kg_m2", b.inertia_kg_m2},
                {"drive.coulomb.torque_nm", b.coulomb_nm},
                {"drive.viscous.b_nm_s_per_rad", b.viscous_nm_s_per_rad}};
  for (const auto& e : c.concealed)
    for (const auto& [key, value] : e.parameters)
      if (!is_nameless(e)) truth[e.name + "." + key] = value;
  return truth;
}

/// On the module's clock, where a tool will speak of it.
json located_in(const Case& c) {
  const DeviceClock& clock = c.sensing.module_clock;
  json out = json::object();
  for (const auto& [from, to] : c.located.intervals_s)
    out["intervals_s"].push_back({clock.reads(from), clock.reads(to)});
  for (const double t : c.located.instants_s) out["instants_s"].push_back(clock.reads(t));
  for (const auto& r : c.located.regions)
    out["regions"].push_back({{"channel", r.channel}, {"from", r.from}, {"to", r.to}});
  return out;
}

const char* name_of(Strength strength) {
  switch (strength) {
    case Strength::faint:
      return "faint";
    case Strength::weak:
      return "weak";
    case Strength::medium:
      return "medium";
    case Strength::strong:
      return "strong";
    case Strength::obvious:
      return "obvious";
    default:
      return "none";
  }
}

}  // namespace

json answer_for(const Case& c) {
  json forms = json::object(), comparable = json::array(), effects = json::array();
  for (const auto& e : c.concealed) {
    effects.push_back(e.name);
    forms[e.name] = e.form;
    for (const auto& key : e.comparable) comparable.push_back(e.name + "." + key);
  }
  const auto path = [](const BeforeAfter& p) {
    return json{{"before", p.before}, {"after", p.after}};
  };
  const DeviceClock &module = c.sensing.module_clock, &loadcell = c.sensing.loadcell_clock;
  return {{"effects", effects},
          {"level", c.item.level},
          {"truth", truth_of(c)},
          {"clock",
           {{"module_rate_error_ppm", module.rate_error_ppm},
            {"module_offset_s", module.offset_s},
            {"loadcell_rate_error_ppm", loadcell.rate_error_ppm},
            {"loadcell_offset_s", loadcell.offset_s}}},
          {"rho", c.concealed.empty() ? 0.0 : c.reachable.rho()},
          {"reachable_rmse_nm",
           {{"spring", path(c.reachable.spring)}, {"drive", path(c.reachable.drive)}}},
          {"stratum", c.item.stratum},
          {"variant", c.item.variant},
          {"strength", name_of(c.item.strength)},
          {"visible", c.visible},
          {"forms", forms},
          {"comparable", comparable},
          {"noise", c.sensing.noise.loadcell_kind},
          {"located", located_in(c)}};
}

}  // namespace searig::proving
