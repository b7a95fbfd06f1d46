#include "estimator/diagnosis/answer/next_experiment.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "estimator/diagnosis/fit/polish.h"
#include "estimator/model/predict.h"
#include "estimator/order.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

using Kind = PlannedMotion::Kind;

constexpr double rehearsal_s = 60.0;
constexpr std::size_t polished = 3;
constexpr double slowest_hz = 0.05;
constexpr double little_faster = 1.5;  // than the recording was, a rig may be asked for

double rounded(double x) {  // to two figures: nobody sets a rig to 0.198765 rad
  if (!(x > 0)) return 0.0;
  const double unit = std::pow(10.0, std::floor(std::log10(x)) - 1.0);
  return std::floor(x / unit) * unit;
}

std::vector<double> constant(const std::vector<double>& like, std::size_t n) {
  if (like.empty()) return {};
  return std::vector<double>(n, median(like));
}

/// What the module and the load cell would say on the motion, were the model right.
Signals rehearse(const PlannedMotion& motion, const Model& model, const Experiment& like) {
  Signals out;
  ModuleSignals& m = out.module;
  m = angles_of(motion, 1.0 / median_step(like.motion.t));
  m.winding_temperature_c = constant(like.motion.winding_c, m.t_s.size());
  m.spring_temperature_c = constant(like.motion.spring_c, m.t_s.size());
  const Torques torques = predict(model, m);
  if (like.has_drive()) m.current_a = current_for(model, m, torques.spring_nm);
  for (double t = 0.0; t < motion.seconds; t += median_step(like.loadcell_t))
    out.loadcell.t_s.push_back(t);
  out.loadcell.torque_nm = sample_at(m.t_s, torques.loadcell_nm, out.loadcell.t_s);
  out.clock_ci95_s = 1.96 * like.clock_sd_s;
  return out;
}

/// What of a hypothesis another motion can show: atoms are places in the recording, and a locked
/// output has no gravity to feel.
Hypothesis shown_by(const Motion& motion, Hypothesis hypothesis) {
  std::erase_if(hypothesis, [&](const Piece& p) { return p.atom || !p.effect->applies(motion); });
  return hypothesis;
}

}  // namespace

std::vector<PlannedMotion> motion_library(const Motion& seen) {
  const double reach_rad = rounded(reach(seen.theta));
  const double swing = rounded(seen.q_o.empty() ? 0.0 : reach(seen.q_o));
  // A sine's rate peaks at 2 pi f A.
  const double fastest = std::max(
      2.0 * slowest_hz, rounded(little_faster * reach(seen.theta_rate) / (2.0 * M_PI * reach_rad)));
  const double between = rounded(std::sqrt(slowest_hz * fastest));
  std::vector<PlannedMotion> out{
      {Kind::triangle, rehearsal_s, {reach_rad}, {slowest_hz}, 0.0},
      {Kind::triangle, rehearsal_s, {reach_rad}, {slowest_hz, between, fastest}, 0.0},
      {Kind::triangle, rehearsal_s, {reach_rad, rounded(reach_rad / 3)}, {2 * slowest_hz}, 0.0},
      {Kind::triangle, rehearsal_s, {rounded(reach_rad / 6)}, {slowest_hz}, 0.0},
      {Kind::sine,
       rehearsal_s,
       {rounded(reach_rad / 4), rounded(reach_rad / 2), reach_rad},
       {between},
       0.0},
      {Kind::staircase, rehearsal_s, {reach_rad}, {0.5}, 0.0},
      {Kind::hold, rehearsal_s, {reach_rad}, {1.0 / 12.0}, 0.0},
      {Kind::multisine, rehearsal_s, {reach_rad}, {fastest}, 0.0},
      {Kind::multisine, rehearsal_s, {reach_rad}, {between}, 0.0},
  };
  if (swing > 0.0)  // some effects want the lever to move
    for (std::size_t i : {1u, 5u, 7u}) {
      out.push_back(out[i]);
      out.back().output_rad = swing;
    }
  return out;
}

Rehearsal::Rehearsal(const Bench& bench, const Hypothesis& truth, const Model& extended) {
  const Experiment& e = bench.experiment();
  if (!e.has_spring() || !extended.has("spring.linear")) return;  // nothing to prescribe
  for (const PlannedMotion& motion : motion_library(e.motion)) {
    Bench stage(prepare(rehearse(motion, extended, e), e.motion.smoothing_rad_s));
    stage.take_noise_of(bench);
    stage.learn_torque(shown_by(stage.experiment().motion, truth));
    stages_.push_back({motion, std::move(stage)});
  }
}

/// Of the rival that does best on the stage, after so many rounds of fitting its shapes.
double Rehearsal::least_deviance(const Stage& stage, const std::vector<Hypothesis>& rivals,
                                 int rounds) {
  double least = std::numeric_limits<double>::infinity();
  for (const Hypothesis& whole : rivals) {
    Hypothesis rival = shown_by(stage.bench.experiment().motion, whole);
    if (rounds > 0) rival = polish(stage.bench, std::move(rival), rounds);
    least = std::min(least, stage.bench.fit(rival).solution.sse);
  }
  return least;
}

std::optional<Rehearsal::Choice> Rehearsal::best_against(
    const std::vector<Hypothesis>& rivals) const {
  if (rivals.empty() || stages_.empty()) return std::nullopt;
  // Shapes cost most to fit, so they are fitted only where the amplitudes alone promise much.
  std::vector<std::pair<double, const Stage*>> promising;
  for (const Stage& stage : stages_)
    promising.emplace_back(least_deviance(stage, rivals, 0), &stage);
  std::ranges::sort(promising, std::greater{}, &std::pair<double, const Stage*>::first);
  std::optional<Choice> best;
  for (std::size_t i = 0; i < std::min(polished, promising.size()); ++i) {
    const Stage& stage = *promising[i].second;
    const double deviance = least_deviance(stage, rivals, 6);
    if (!best || deviance > best->deviance) best = Choice{stage.motion, deviance};
  }
  return best;
}

}  // namespace searig::estimator
