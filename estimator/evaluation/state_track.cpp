#include "estimator/evaluation/state_track.h"

#include <cmath>
#include <stdexcept>

#include "estimator/filter/fixed_lag.h"

namespace searig::estimator {

namespace {

constexpr double half_width_s = 0.02;  // of the window for the rate, as OnlineOptions has it

constexpr double slowest = 0.05;  // of the mean rate: what is slower rests

// Departure: (3) gives a rest as much weight as the noise of its rate happens to make; here none.
bool is_moving(double rate, const Size& size) {
  return std::abs(rate) > slowest * size.deflection_rate_rad_s;
}

Motion motion_for(const ModuleSignals& module, const SpringStates& states) {
  Motion motion = motion_of(module, half_width_s);
  if (const std::string channel = states.lacks(motion); !channel.empty()) {
    throw std::invalid_argument("the recording has no " + channel + ", which a state needs");
  }
  return motion;
}

}  // namespace

StateTrack track_states(const ModuleSignals& module, const std::vector<double>& drive_nm,
                        EstimatorKind kind, const SpringStates& states,
                        const StateOptions& options) {
  const auto estimator = make_state_estimator(kind, states, options);
  const Motion motion = motion_for(module, states);
  const Eigen::MatrixXd phi = states.regressors(motion);
  const auto rows = static_cast<Eigen::Index>(motion.size());
  const int n = states.size();

  StateTrack out{.torque_nm = {}, .x = Eigen::MatrixXd(rows, n), .parameters = {}};
  SizeTracker size(half_width_s, 1);
  Eigen::VectorXd phi_now(n), x(n);
  for (Eigen::Index i = 0; i < rows; ++i) {
    const auto at = static_cast<std::size_t>(i);
    const double theta = motion.theta[at], rate = motion.theta_rate[at];
    const FixedLag::Sample sample{motion.t[at], module.deflection_rad[at], drive_nm[at]};
    const bool sound = std::isfinite(sample.deflection + sample.drive + theta + rate);
    const bool seen_moving = sound && size.add({sample, theta, rate});
    const auto known = size.size();
    const bool moves = seen_moving && (!known || is_moving(rate, *known));
    const double weight =
        moves && known ? trust_weight(theta, rate, options.paper.scaled_to(*known).gamma) : 0;
    phi_now = phi.row(i);
    const double dt = i > 0 ? motion.t[at] - motion.t[at - 1] : 0;
    estimator->step({dt, theta, sample.drive, weight, moves, {phi_now.data(), std::size_t(n)}});
    estimator->state({x.data(), std::size_t(n)});
    out.x.row(i) = x;
    out.torque_nm.push_back(phi_now.dot(x));
  }

  const auto known = estimator->covariance();
  out.has_interval = known.has_value();
  out.parameters = states.parameters(x, known ? known->covariance : Eigen::MatrixXd::Zero(n, n),
                                     known ? known->dof : Eigen::VectorXd::Zero(n));
  return out;
}

}  // namespace searig::estimator
