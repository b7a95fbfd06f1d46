#include "estimator/evaluation/online_result.h"

#include <cmath>
#include <utility>

namespace searig::estimator {

namespace {

constexpr double converged_within = 0.05;  // of the best fit

OnlineOptions online_options(double initial_k, const EvaluationOptions& options) {
  if (options.exactly_as_the_paper) return exactly_as_the_paper(initial_k);
  return {.initial_k_nm_per_rad = initial_k};
}

}  // namespace

std::optional<double> online_start(const Model* model, const EvaluationOptions& options,
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

OnlineRun::OnlineRun(double initial_k_nm_per_rad, const EvaluationOptions& options,
                     const std::optional<BestFit>& best_fit, std::span<const double> loadcell_s,
                     Track track)
    : online_(online_options(initial_k_nm_per_rad, options)), k_at_(loadcell_s), track_(track) {
  out_.initial_k_nm_per_rad = initial_k_nm_per_rad;
  out_.trust_weight_s = 0;
  if (best_fit) best_k_ = best_fit->k_nm_per_rad;
}

void OnlineRun::push(double t_s, double deflection_rad, double drive_nm) {
  online_.push(t_s, deflection_rad, drive_nm);
  while (const auto estimate = online_.next()) take(*estimate);
}

bool OnlineRun::near(double k_nm_per_rad) const {
  return std::abs(k_nm_per_rad - *best_k_) <= converged_within * std::abs(*best_k_);
}

/// Time and trust weight up to the last estimate that is further than 5 % from the best fit.
void OnlineRun::take(const OnlineEstimate& estimate) {
  if (before_) {
    out_.trust_weight_s += before_->weight * (estimate.t_s - before_->t_s);
    if (best_k_ && !near(before_->k_nm_per_rad))
      so_far_ = {estimate.t_s - first_s_, out_.trust_weight_s};
  } else {
    first_s_ = estimate.t_s;
  }
  before_ = estimate;
  k_at_.push(estimate.t_s, estimate.k_nm_per_rad);
  if (track_ == Track::kept) out_.track.push_back(estimate);
}

std::span<const OnlineEstimate> OnlineRun::take_track() {
  taken_.clear();
  std::swap(taken_, out_.track);
  return taken_;
}

std::optional<OnlineResult> OnlineRun::finish(const Survey& survey,
                                              std::vector<std::string>& notes) {
  if (!before_) {
    notes.push_back("too few finite samples: the online estimate is switched off");
    return std::nullopt;
  }
  out_.k_nm_per_rad = before_->k_nm_per_rad;
  auto torque = k_at_.finish();  // k theta, with the k of that moment
  for (std::size_t i = 0; i < torque.size(); ++i) torque[i] *= survey.deflection_rad[i];
  out_.score = score(torque, survey.loadcell.torque_nm);
  if (out_.trust_weight_s == 0)
    notes.push_back("no sample was trusted: the online estimate stayed where it started");
  if (best_k_ && near(before_->k_nm_per_rad)) out_.convergence = so_far_;
  return std::move(out_);
}

}  // namespace searig::estimator
