#include "app/rig/live_follower.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace searig::app {
namespace {

constexpr double kept_s = 3.0;        // of samples: more than anything here looks back
constexpr double rate_over_s = 0.02;  // of the torque: encoder steps must not show
constexpr double nowhere = -std::numeric_limits<double>::infinity();
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

std::size_t behind(const std::vector<double>& t_s, double t) {
  return static_cast<std::size_t>(std::upper_bound(t_s.begin(), t_s.end(), t) - t_s.begin());
}

}  // namespace

LiveFollower::LiveFollower(const FollowOptions& options)
    : signals_(options.lever_arm_m), loadcell_until_s_(nowhere), residual_until_s_(nowhere) {
  if (!options.model) return;
  const auto start = start_from(*options.model, 1.0);
  stream_.emplace(*options.model, start);
  interval_.emplace(start.initial_k_nm_per_rad);
}

void LiveFollower::take(const std::vector<acquisition::Entry>& entries) {
  for (const acquisition::Entry& entry : entries) rolling_.take(entry);
  signals_.take(entries);
  if (!start_s_ && !signals_.signals().module.t_s.empty())
    start_s_ = signals_.signals().module.t_s.front();
}

void LiveFollower::hold_clocks() {
  if (const auto map = rolling_.estimate()) {
    clock_ = map;
    signals_.place(*map);
  }
}

double LiveFollower::now_s() const {
  const auto& t_s = signals_.signals().module.t_s;
  return t_s.empty() ? 0.0 : t_s.back() - *start_s_;
}

void LiveFollower::follow(LiveColumns& out) {
  if (!start_s_) return;
  hand_on_loadcell(out);
  fresh_.clear();
  if (stream_) stream_->follow(signals_.signals().module, false, fresh_);
  for (const auto& estimate : fresh_) take_estimate(estimate, out);
  take_residuals(out);
  // What the stream has not followed has to stay, with its neighbours.
  const std::size_t gone = signals_.keep_last(kept_s);
  if (stream_) stream_->forget(std::min(gone, stream_->followed()));
}

void LiveFollower::hand_on_loadcell(LiveColumns& out) {
  const auto& loadcell = signals_.signals().loadcell;
  for (std::size_t i = behind(loadcell.t_s, loadcell_until_s_); i < loadcell.t_s.size(); ++i) {
    out.loadcell_t_s.push_back(loadcell.t_s[i] - *start_s_);
    out.loadcell_nm.push_back(loadcell.torque_nm[i]);
  }
  if (!loadcell.t_s.empty()) loadcell_until_s_ = std::max(loadcell_until_s_, loadcell.t_s.back());
}

void LiveFollower::take_estimate(const estimator::OnlineEstimate& e, LiveColumns& out) {
  interval_->take(e);
  const auto k = interval_->interval();
  const double ends[] = {(k ? k->low : unknown) * e.deflection_rad,
                         (k ? k->high : unknown) * e.deflection_rad};
  const auto [low, high] = std::minmax(ends[0], ends[1]);

  const auto& t_s = signals_.signals().module.t_s;
  const std::size_t seen = behind(t_s, e.t_s);
  if (seen == 0) return;  // of before a pause, and let go of since
  const std::size_t sample = seen - 1;
  lately_.push_back({e.t_s, e.torque_nm, regime_at(sample, e.torque_nm)});
  while (lately_.front().t_s < e.t_s - kept_s) lately_.pop_front();
  // A clock that may be off by so much moves a slope by so much torque.
  const auto before = std::lower_bound(lately_.begin(), lately_.end(), e.t_s - rate_over_s,
                                       [](const Estimated& a, double t) { return a.t_s < t; });
  const double passed_s = e.t_s - before->t_s;
  const double rate = passed_s > 0.0 ? (e.torque_nm - before->torque_nm) / passed_s : 0.0;
  const double by_clock = clock_ ? std::abs(rate) * clock_->ci95_s : unknown;

  out.t_s.push_back(e.t_s - *start_s_);
  out.torque_nm.push_back(e.torque_nm);
  out.low_nm.push_back(low);
  out.high_nm.push_back(high);
  out.clock_low_nm.push_back(low - by_clock);
  out.clock_high_nm.push_back(high + by_clock);
  out.weight.push_back(e.weight);
  out.k_nm_per_rad.push_back(e.k_nm_per_rad);
  out.k_low_nm_per_rad.push_back(k ? k->low : unknown);
  out.k_high_nm_per_rad.push_back(k ? k->high : unknown);
  const auto& output_rad = signals_.signals().module.output_angle_rad;
  out.deflection_rad.push_back(e.deflection_rad);
  out.output_angle_rad.push_back(output_rad.empty() ? unknown : output_rad[sample]);
}

estimator::Regime LiveFollower::regime_at(std::size_t sample, double torque_nm) {
  const estimator::ModuleSignals& m = signals_.signals().module;
  double velocity = 0.0;
  if (!m.input_velocity_rad_s.empty()) {
    velocity = m.input_velocity_rad_s[sample];
  } else if (!m.input_angle_rad.empty()) {
    const std::size_t before = std::min(behind(m.t_s, m.t_s[sample] - rate_over_s), sample);
    const double passed_s = m.t_s[sample] - m.t_s[before];
    if (passed_s > 0.0)
      velocity = (m.input_angle_rad[sample] - m.input_angle_rad[before]) / passed_s;
  }
  const double current = m.current_a.empty() ? 0.0 : m.current_a[sample];
  return regimes_.take(m.t_s[sample], velocity, torque_nm, current);
}

/// Where the estimate has come past a reading of the load cell.
void LiveFollower::take_residuals(LiveColumns& out) {
  if (lately_.empty()) return;
  const auto& loadcell = signals_.signals().loadcell;
  for (std::size_t i = behind(loadcell.t_s, residual_until_s_); i < loadcell.t_s.size(); ++i) {
    const double t = loadcell.t_s[i];
    if (t > lately_.back().t_s) return;
    residual_until_s_ = t;
    const auto after = std::lower_bound(lately_.begin(), lately_.end(), t,
                                        [](const Estimated& a, double at) { return a.t_s < at; });
    if (after == lately_.begin()) continue;
    const auto& a = *std::prev(after);
    const auto& b = *after;
    const double share = (t - a.t_s) / (b.t_s - a.t_s);
    const double estimated = a.torque_nm + share * (b.torque_nm - a.torque_nm);
    auto& residuals = out.residuals[static_cast<std::size_t>(b.regime)];
    residuals.t_s.push_back(t - *start_s_);
    residuals.nm.push_back(loadcell.torque_nm[i] - estimated);
  }
}

void LiveFollower::tail(std::vector<double>& t_s, std::vector<double>& torque_nm) const {
  t_s.clear();
  torque_nm.clear();
  const auto& module = signals_.signals().module;
  if (!stream_ || lately_.empty() || module.deflection_rad.empty()) return;
  t_s.push_back(lately_.back().t_s - *start_s_);  // so that the curve goes on
  torque_nm.push_back(lately_.back().torque_nm);
  const double k = stream_->k_nm_per_rad();
  for (std::size_t i = behind(module.t_s, lately_.back().t_s); i < module.t_s.size(); ++i) {
    t_s.push_back(module.t_s[i] - *start_s_);
    torque_nm.push_back(k * module.deflection_rad[i]);
  }
}

}  // namespace searig::app
