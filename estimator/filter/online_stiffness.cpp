#include "estimator/filter/online_stiffness.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace searig::estimator {

namespace {

using Scalar = Eigen::Vector<double, 1>;

constexpr double largest_change_per_step = 10;  // factor
constexpr double largest_change = 1e6;          // factor from the initial stiffness, ever

const OnlineOptions& checked(const OnlineOptions& options) {
  const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
  if (!positive(options.initial_k_nm_per_rad)) {
    throw std::invalid_argument("the initial stiffness must be a number above 0");
  }
  const PaperUnits& paper = options.paper;
  if (!positive(paper.gamma) || !positive(paper.alpha) || !positive(paper.beta)) {
    throw std::invalid_argument("gamma, alpha and beta must be numbers above 0");
  }
  if (!positive(options.initial_relative_sd) ||
      !(options.largest_relative_sd >= options.initial_relative_sd)) {
    throw std::invalid_argument("the standard deviation at most must not be below the initial one");
  }
  if (options.samples_per_step == 0) {
    throw std::invalid_argument("a filter step needs at least one sample");
  }
  return options;
}

// The variance that stands for a share of the module's own torque over deflection; no numbers that
// a file can hold make it 0 or infinite.
double variance_of(double relative_sd, const Size& size) {
  const double variance = std::pow(relative_sd * size.torque_nm / size.deflection_rad, 2);
  return std::clamp(variance, 1e-200, 1e200);
}

}  // namespace

OnlineStiffness::OnlineStiffness(const OnlineOptions& options)
    : options_(checked(options)),
      lag_(options.half_width_s),
      tracker_(options.half_width_s, options.samples_per_step) {
  since_last_step_.reserve(options.samples_per_step);
}

double OnlineStiffness::k_nm_per_rad() const {
  return filter_ ? filter_->state()(0) : options_.initial_k_nm_per_rad;
}

double OnlineStiffness::variance() const {
  return filter_ ? filter_->covariance()(0) : std::numeric_limits<double>::infinity();
}

std::optional<OnlineEstimate> OnlineStiffness::next() {
  const auto rated = lag_.next();
  if (!rated) return std::nullopt;
  const auto& [t, theta, drive] = rated->sample;
  tracker_.add(*rated);

  double weight = 0;
  if (const auto known = size()) {
    weight = trust_weight(theta, rated->rate, options_.paper.scaled_to(*known).gamma);
    since_last_step_.push_back({theta, drive, weight});
    if (since_last_step_.size() == options_.samples_per_step) filter_step(*known);
  }
  const double k = k_nm_per_rad();
  return OnlineEstimate{t, k, variance(), weight, theta, drive, k * theta};
}

// (7), (10): k stands still, Q = alpha k.  (8), (9), (11): an error of 0 is observed, R = beta.
void OnlineStiffness::filter_step(const Size& size) {
  if (!filter_) {
    const double variance = variance_of(options_.initial_relative_sd, size);
    filter_.emplace(Scalar(options_.initial_k_nm_per_rad), Scalar(variance));
  }
  const PaperUnits units = options_.paper.scaled_to(size);
  const double before = k_nm_per_rad();
  const double room = variance_of(options_.largest_relative_sd, size) - variance();
  const double Q = std::clamp(process_noise(units.alpha, before), 0.0, std::max(0.0, room));
  const auto error = [this](const Scalar& k) { return mean_squared_error(since_last_step_, k(0)); };
  if (filter_->predict(Scalar(Q)) && filter_->update(error, 0.0, units.beta)) keep_near(before);
  since_last_step_.clear();
}

void OnlineStiffness::keep_near(double before) {
  const double initial = options_.initial_k_nm_per_rad;
  const double least = std::max(before / largest_change_per_step, initial / largest_change);
  const double most = std::min(before * largest_change_per_step, initial * largest_change);
  filter_->set_state(Scalar(std::clamp(k_nm_per_rad(), least, most)));
}

}  // namespace searig::estimator
