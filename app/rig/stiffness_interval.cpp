#include "app/rig/stiffness_interval.h"

#include <cmath>
#include <limits>

#include "estimator/filter/spring_states.h"

namespace searig::app {
namespace {

constexpr double ask_every_s = 0.1;  // an interval costs more than a step, and changes slowly

estimator::StateOptions from(double initial_k_nm_per_rad) {
  estimator::StateOptions options;
  options.initial_k_nm_per_rad = initial_k_nm_per_rad;
  return options;
}

}  // namespace

StiffnessInterval::StiffnessInterval(double initial_k_nm_per_rad)
    : filter_(estimator::make_state_estimator(estimator::EstimatorKind::linear,
                                              estimator::SpringStates({"spring.linear"}),
                                              from(initial_k_nm_per_rad))),
      last_s_(std::numeric_limits<double>::quiet_NaN()),
      asked_s_(-std::numeric_limits<double>::infinity()) {}

void StiffnessInterval::take(const estimator::OnlineEstimate& sample) {
  const double theta = sample.deflection_rad;
  const double dt_s = std::isnan(last_s_) ? 0.0 : sample.t_s - last_s_;
  filter_->step({dt_s, theta, sample.drive_nm, sample.weight, sample.weight > 0.0, {&theta, 1}});
  last_s_ = sample.t_s;
  if (sample.t_s >= asked_s_ + ask_every_s) ask();
}

void StiffnessInterval::ask() {
  asked_s_ = last_s_;
  interval_.reset();
  const auto known = filter_->covariance();
  if (!known) return;
  double k = 0.0;
  filter_->state({&k, 1});
  const double half = estimator::student_95(known->dof(0)) * std::sqrt(known->covariance(0, 0));
  if (std::isfinite(k + half)) interval_ = Interval{k - half, k + half};
}

}  // namespace searig::app
