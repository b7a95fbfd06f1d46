#include "estimator/evaluation/online_result.h"

#include <cmath>

#include "estimator/model/predict.h"

namespace searig::estimator {

namespace {

constexpr double converged_within = 0.05;  // of the best fit

std::optional<double> start(const Model* model, const EvaluationOptions& options,
                            const std::optional<BestFit>& best_fit,
                            std::vector<std::string>& notes) {
  if (options.initial_k_nm_per_rad) return options.initial_k_nm_per_rad;
  const auto believed = model ? model->get("spring.linear", "k_nm_per_rad") : std::nullopt;
  if (believed && *believed > 0) {
    notes.push_back("the online estimate starts from the model's stiffness");
    return believed;
  }
  if (best_fit && best_fit->k_nm_per_rad > 0) {
    notes.push_back("the online estimate starts from the best fit, for nothing else is known");
    return best_fit->k_nm_per_rad;
  }
  notes.push_back("no stiffness to start from: the online estimate is switched off");
  return std::nullopt;
}

std::vector<OnlineEstimate> track_of(const ModuleSignals& module, const DriveTorque& drive,
                                     const OnlineOptions& options) {
  OnlineStiffness online(options);
  std::vector<OnlineEstimate> track;
  track.reserve(module.t_s.size());
  for (std::size_t i = 0; i < module.t_s.size(); ++i) {
    online.push(module.t_s[i], module.deflection_rad[i], drive.nm[i]);
    while (const auto estimate = online.next()) track.push_back(*estimate);
  }
  return track;
}

// k theta at the load cell's samples, with the k of that moment.
Score score_of(const Signals& signals, const std::vector<OnlineEstimate>& track) {
  std::vector<double> t, k;
  for (const OnlineEstimate& estimate : track) {
    t.push_back(estimate.t_s);
    k.push_back(estimate.k_nm_per_rad);
  }
  const auto& at = signals.loadcell.t_s;
  auto torque = sample_at(signals.module.t_s, signals.module.deflection_rad, at);
  const auto k_then = sample_at(t, k, at);
  for (std::size_t i = 0; i < torque.size(); ++i) torque[i] *= k_then[i];
  return score(torque, signals.loadcell.torque_nm);
}

// Time and trust weight up to the last estimate that is further than 5 % from k.
std::optional<Convergence> convergence_to(double k, const std::vector<OnlineEstimate>& track) {
  Convergence out{0, 0};
  double weight_s = 0;
  for (std::size_t i = 0; i + 1 < track.size(); ++i) {
    const double until = track[i + 1].t_s;
    weight_s += track[i].weight * (until - track[i].t_s);
    if (std::abs(track[i].k_nm_per_rad - k) <= converged_within * std::abs(k)) continue;
    out = {until - track.front().t_s, weight_s};
  }
  if (std::abs(track.back().k_nm_per_rad - k) > converged_within * std::abs(k)) return std::nullopt;
  return out;
}

double total_weight_s(const std::vector<OnlineEstimate>& track) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < track.size(); ++i) {
    sum += track[i].weight * (track[i + 1].t_s - track[i].t_s);
  }
  return sum;
}

}  // namespace

std::optional<OnlineResult> follow_online(const Signals& signals, const Model* model,
                                          const DriveTorque& drive,
                                          const EvaluationOptions& options,
                                          const std::optional<BestFit>& best_fit,
                                          std::vector<std::string>& notes) {
  const auto initial = start(model, options, best_fit, notes);
  if (!initial) return std::nullopt;
  OnlineOptions online{.initial_k_nm_per_rad = *initial};
  if (options.exactly_as_the_paper) online = exactly_as_the_paper(*initial);

  OnlineResult out;
  out.initial_k_nm_per_rad = *initial;
  out.track = track_of(signals.module, drive, online);
  if (out.track.empty()) {
    notes.push_back("too few finite samples: the online estimate is switched off");
    return std::nullopt;
  }
  out.k_nm_per_rad = out.track.back().k_nm_per_rad;
  out.score = score_of(signals, out.track);
  out.trust_weight_s = total_weight_s(out.track);
  if (out.trust_weight_s == 0) {
    notes.push_back("no sample was trusted: the online estimate stayed where it started");
  }
  if (best_fit) out.convergence = convergence_to(best_fit->k_nm_per_rad, out.track);
  return out;
}

}  // namespace searig::estimator
