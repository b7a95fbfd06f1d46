#include "tests/proving/truth/located.h"

#include <algorithm>

#include "tests/proving/plan/draw_motion.h"

namespace searig::proving {
namespace {

void locate_effect(const Effect& e, const Rig& rig, Located& out) {
  const auto around = [&](const char* channel, double width) {
    out.regions.push_back({channel, e.at("centre_rad") - width, e.at("centre_rad") + width});
  };
  if (e.form == "snag") around("input_angle_rad", 2.0 * e.at("width_rad"));
  if (e.form == "detent") around("deflection_rad", 2.0 * e.at("width_rad"));
  if (e.form == "missing_codes")
    out.regions.push_back({"deflection_rad", e.at("low_nm") / rig.base.stiffness_nm_per_rad,
                           e.at("high_nm") / rig.base.stiffness_nm_per_rad});
  if (e.form == "saturation") {
    const double peak = e.at("peak_nm") / rig.base.stiffness_nm_per_rad;
    out.regions.push_back({"deflection_rad", peak * (1.0 - e.at("depth_share")), peak});
  }
  if (is_nameless(e) && e.parameters.contains("to_s"))
    out.intervals_s.emplace_back(e.at("from_s"), e.at("to_s"));
  else if (is_nameless(e) && e.parameters.contains("from_s"))
    out.instants_s.push_back(e.at("from_s"));
}

/// Only where the rare regime coincides with one segment can the effect be seen.
void locate_regime(const Rig& rig, const std::string& variant, Located& out) {
  std::string segment;
  if (variant == "one fast burst") segment = "fast_burst";
  if (variant == "one large burst") segment = "multisine";
  if (variant == "one slow stretch") segment = "slow_sweep";
  // A spring that is nearly always loaded on one side shows the rest in its constant offset.
  if (variant == "rare zero crossing") {
    const Effect* play = rig.find("spring.deadzone");
    out.regions.push_back({"deflection_rad", -10.0, play ? play->at("half_width_rad") : 0.0});
  }
  if (segment.empty()) return;
  const auto [from, to] = segment_interval(rig.plan, segment, rig.duration_s + rig.preroll_s);
  out.intervals_s.emplace_back(std::max(0.0, from - rig.preroll_s),
                               std::min(rig.duration_s, to - rig.preroll_s));
}

}  // namespace

Located locate(const Rig& rig, const std::string& variant) {
  Located out;
  for (const auto& e : rig.effects) locate_effect(e, rig, out);
  locate_regime(rig, variant, out);
  return out;
}

}  // namespace searig::proving
