#include "tests/proving/plan/draw_motion.h"

#include <algorithm>

namespace searig::proving {
namespace {

using Names = std::vector<std::string>;

void shuffle(Names& names, Random& random) {
  for (std::size_t i = names.size(); i > 1; --i)
    std::swap(names[i - 1],
              names[static_cast<std::size_t>(random.integer(0, static_cast<int>(i) - 1))]);
}

/// What an effect needs to be told from its rivals (notes: diagnosis, section 2.4).
Names needed_by(const std::string& effect) {
  if (effect == "spring.relaxation" || effect == "spring.hysteresis")
    return {"steps", "triangles", "multisine"};
  if (effect == "spring.mullins") return {"growing", "multisine"};
  if (effect == "drive.stribeck" || effect == "drive.ripple") return {"slow_sweep", "triangles"};
  if (effect == "drive.inertia" || effect == "rig.inertia") return {"fast_burst", "chirp"};
  if (effect == "rig.lag" || effect == "rig.delay" || effect == "spring.viscous")
    return {"chirp", "triangles"};
  if (effect == "drive.load_friction" || effect == "drive.torque_constant_temperature")
    return {"hand", "triangles"};
  return {"multisine"};
}

Names rich(const Item& item, Random& random) {
  Names names;
  for (const auto& effect : item.effects)
    for (const auto& need : needed_by(effect))
      if (std::find(names.begin(), names.end(), need) == names.end()) names.push_back(need);
  Names others{"multisine", "triangles", "staircase", "chirp",
               "hand",      "steps",     "rest",      "multisine"};
  shuffle(others, random);
  const auto total =
      std::max<std::size_t>(names.size() + 1, static_cast<std::size_t>(random.integer(3, 6)));
  for (const auto& other : others)
    if (names.size() < total) names.push_back(other);
  shuffle(names, random);
  const auto first = std::find(names.begin(), names.end(), "growing");
  if (first != names.end()) std::iter_swap(names.begin(), first);  // virgin loading comes once
  return names;
}

Names masked(const std::string& variant, Random& random) {
  Names names;
  if (variant == "one fast burst")
    names = {"slow_triangle", "steps", "slow_sweep", "slow_triangle", "fast_burst"};
  if (variant == "one large burst") names = {"small", "small", "small", "small", "multisine"};
  if (variant == "one slow stretch")
    names = {"multisine", "chirp", "multisine", "fast_burst", "slow_sweep"};
  if (variant == "rare zero crossing") names = {"small", "small", "small", "multisine", "small"};
  shuffle(names, random);
  return names;
}

/// A rest says little for long; everything else gets about as much time.
std::vector<double> draw_shares(const Names& segments, Random& random) {
  std::vector<double> shares;
  double sum = 0.0;
  for (const auto& name : segments) {
    shares.push_back(name == "rest" ? 0.3 : random.uniform(0.7, 1.3));
    sum += shares.back();
  }
  for (double& share : shares) share /= sum;
  return shares;
}

MotionPlan draw_segments(const Item& item, Random& random) {
  MotionPlan plan;
  plan.motor_amplitude_rad = random.log_uniform(0.3, 0.9);
  plan.hand_amplitude_rad = plan.motor_amplitude_rad * random.uniform(0.45, 0.9);
  plan.pace = random.log_uniform(0.7, 1.4);
  plan.generator_hz = random.uniform(1.8, 4.0);
  if (item.stratum == "poor") {
    plan.segments = {item.variant};
    plan.pace = 1.0;
    if (item.variant == "sine") plan.motor_amplitude_rad *= 0.5;
    return plan;
  }
  plan.segments = item.stratum == "masked" && item.variant != "adapted"
                      ? masked(item.variant, random)
                      : rich(item, random);
  if (item.variant == "rare zero crossing") plan.bias_rad = 0.55 * plan.motor_amplitude_rad;
  return plan;
}

}  // namespace

MotionPlan draw_motion(const Item& item, Random random) {
  MotionPlan plan = draw_segments(item, random);
  plan.shares = draw_shares(plan.segments, random);
  return plan;
}

std::pair<double, double> segment_interval(const MotionPlan& plan, const std::string& name,
                                           double duration_s) {
  double start = 0.0;
  for (std::size_t i = 0; i < plan.segments.size(); ++i) {
    const double lasts = plan.shares[i] * duration_s;
    if (plan.segments[i] == name) return {start, start + lasts};
    start += lasts;
  }
  return {0.0, 0.0};
}

}  // namespace searig::proving
