#include "app/reproduce/trial.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "app/rig/simulated_rig.h"
#include "app/session/session.h"
#include "estimator/evaluation/score.h"
#include "estimator/evaluation/state_track.h"
#include "estimator/model/predict.h"
#include "estimator/twin/paper_module.h"

namespace searig::app::reproduce {
namespace {

using estimator::Evaluation;
using estimator::OnlineEstimate;
using estimator::sample_at;

/// Through the devices' own clocks and links, brought onto one clock as any recording is.
estimator::Signals record(std::uint64_t seed, Hand hand, double seconds) {
  RigSettings settings;
  settings.parameters = estimator::twin::paper_module(seed);
  if (hand == Hand::drags_along) {
    settings.parameters.motion = estimator::twin::MotionParameters{};
    settings.parameters.lever = estimator::twin::LeverParameters{};
  }
  settings.seed = seed;
  SimulatedRig rig(settings);
  rig.run_until(seconds);
  return session_of(rig.recording()).signals;
}

/// A channel of the track, at the load cell's samples.
std::vector<double> at_loadcell(const std::vector<OnlineEstimate>& track,
                                double OnlineEstimate::*channel,
                                const estimator::LoadcellSignals& loadcell) {
  std::vector<double> t_s, values;
  for (const auto& estimate : track) {
    t_s.push_back(estimate.t_s);
    values.push_back(estimate.*channel);
  }
  return sample_at(t_s, values, loadcell.t_s);
}

/// sum w theta T / sum w theta^2 up to a time, T from the load cell: what a perfect sensor of
/// torque would say of the stiffness at the moments at which the current is trusted.
double trusted_stiffness(const std::vector<OnlineEstimate>& track,
                         const estimator::LoadcellSignals& loadcell, double until_s) {
  const auto w = at_loadcell(track, &OnlineEstimate::weight, loadcell);
  const auto theta = at_loadcell(track, &OnlineEstimate::deflection_rad, loadcell);
  double torque = 0, deflection = 0;
  for (std::size_t i = 0; i < w.size() && loadcell.t_s[i] <= until_s; ++i) {
    torque += w[i] * theta[i] * loadcell.torque_nm[i];
    deflection += w[i] * theta[i] * theta[i];
  }
  return torque / deflection;
}

std::optional<Approach> approach(const std::vector<OnlineEstimate>& track, double k,
                                 const estimator::LoadcellSignals& loadcell,
                                 const Protocol& protocol) {
  double weight_s = 0, time_s = 0, within_s = 0, off_s = 0;
  std::optional<Approach> out;
  for (std::size_t i = 0; i + 1 < track.size(); ++i) {
    const double step_s = track[i + 1].t_s - track[i].t_s;
    const double off = track[i].k_nm_per_rad / k - 1.0;
    weight_s += track[i].weight * step_s;
    if (weight_s < protocol.trust_s) continue;
    if (!out) {
      const double truth = trusted_stiffness(track, loadcell, track[i].t_s);
      out = Approach{track[i].t_s - track.front().t_s, 100 * off, 100 * (truth / k - 1.0), 0, 0};
    }
    time_s += step_s;
    off_s += std::abs(off) * step_s;
    if (std::abs(off) <= protocol.within) within_s += step_s;
  }
  if (!out) return out;
  out->off_later_percent = 100 * off_s / time_s;
  out->within_later_percent = 100 * within_s / time_s;
  return out;
}

/// The current's mean error where it is trusted and elsewhere, over mean |measured|.
void judge_current(const estimator::Signals& signals, const std::vector<OnlineEstimate>& track,
                   TrialFigures& out) {
  const auto w = at_loadcell(track, &OnlineEstimate::weight, signals.loadcell);
  const auto current = at_loadcell(track, &OnlineEstimate::drive_nm, signals.loadcell);
  double trusted = 0, rest = 0, size = 0;
  std::size_t trusted_count = 0;
  for (std::size_t i = 0; i < w.size(); ++i) {
    const double measured = signals.loadcell.torque_nm[i], error = std::abs(current[i] - measured);
    size += std::abs(measured);
    if (w[i] > 0.5) trusted += error, ++trusted_count;
    if (w[i] <= 0.5) rest += error;
  }
  const auto n = static_cast<double>(w.size()), n_trusted = static_cast<double>(trusted_count);
  out.current_trusted_percent = 100 * (trusted / n_trusted) / (size / n);
  out.current_rest_percent = 100 * (rest / (n - n_trusted)) / (size / n);
}

/// A variant's way through a trial.
struct Course {
  estimator::Score score;
  std::vector<OnlineEstimate> track;

  double last_k_nm_per_rad() const { return track.back().k_nm_per_rad; }
};

Course course_of(const Evaluation& evaluation) {
  return {evaluation.online->score, evaluation.online->track};
}

/// The same trust weights and drive torques, with another filter in place of the paper's.
Course course_of(const Evaluation& evaluation, const StateFilter& filter,
                 const estimator::Signals& signals) {
  Course out = course_of(evaluation);
  std::vector<double> drive_nm;
  for (const auto& estimate : out.track) drive_nm.push_back(estimate.drive_nm);
  const auto found = estimator::track_states(
      signals.module, drive_nm, filter.kind, estimator::SpringStates(filter.states),
      {.initial_k_nm_per_rad = evaluation.online->initial_k_nm_per_rad});
  for (std::size_t i = 0; i < out.track.size(); ++i)
    out.track[i].k_nm_per_rad = found.x(static_cast<Eigen::Index>(i), 0);
  const auto& loadcell = signals.loadcell;
  out.score = estimator::score(sample_at(signals.module.t_s, found.torque_nm, loadcell.t_s),
                               loadcell.torque_nm);
  return out;
}

}  // namespace

Trial run_trial(std::uint64_t seed, Hand hand, const Protocol& protocol,
                const std::vector<Variant>& variants) {
  Trial out;
  out.signals = record(seed, hand, protocol.seconds);
  const auto fit = estimator::evaluate(out.signals).best_fit;
  if (!fit || !(fit->k_nm_per_rad > 0)) {
    throw std::runtime_error("trial " + std::to_string(seed) + ": the spring has no best fit");
  }
  out.figures.seed = seed;
  out.figures.best_fit_k_nm_per_rad = fit->k_nm_per_rad;
  out.figures.best_fit = fit->score;
  const auto& loadcell = out.signals.loadcell;
  out.figures.deflection_rad =
      sample_at(out.signals.module.t_s, out.signals.module.deflection_rad, loadcell.t_s);
  out.figures.measured_nm = loadcell.torque_nm;
  for (const Variant& variant : variants) {
    const auto run = [&](double initial_k) {
      return estimator::evaluate(out.signals, &variant.drive, variant.from(initial_k));
    };
    Evaluation good = run(fit->k_nm_per_rad);
    Evaluation poor = run(protocol.poor_start * fit->k_nm_per_rad);
    const auto follow = [&](const Evaluation& e) {
      return variant.filter ? course_of(e, *variant.filter, out.signals) : course_of(e);
    };
    const Course from_poor = follow(poor);
    out.figures.online.push_back(
        {follow(good).score, from_poor.score, from_poor.last_k_nm_per_rad(),
         approach(from_poor.track, fit->k_nm_per_rad, loadcell, protocol)});
    if (&variant != &variants.front()) continue;
    out.figures.current = good.current->score;
    judge_current(out.signals, good.online->track, out.figures);
    out.good = std::move(good);
    out.poor = std::move(poor);
  }
  return out;
}

}  // namespace searig::app::reproduce
