#include "app/session/regime_residuals.h"

namespace searig::app {
namespace {

constexpr double rate_over_s = 0.02;   // as live
constexpr double longest_gap_s = 1.0;  // over which an estimate is taken for a straight line

}  // namespace

double ResidualFinder::velocity() const {
  const auto& m = signals_.module;
  if (!m.input_velocity_rad_s.empty()) return m.input_velocity_rad_s[row_];
  const double passed_s = m.t_s[row_] - m.t_s[row_before_];
  if (m.input_angle_rad.empty() || !(passed_s > 0.0)) return 0.0;
  return (m.input_angle_rad[row_] - m.input_angle_rad[row_before_]) / passed_s;
}

void ResidualFinder::push(double t_s, double torque_nm) {
  const auto& m = signals_.module;
  while (row_ + 1 < m.t_s.size() && m.t_s[row_ + 1] <= t_s) ++row_;
  while (row_before_ < row_ && m.t_s[row_before_] < t_s - rate_over_s) ++row_before_;
  const double current = m.current_a.empty() ? 0.0 : m.current_a[row_];
  auto& residuals = found_[std::size_t(regimes_.take(t_s, velocity(), torque_nm, current))];
  const auto& readings = signals_.loadcell;
  const bool joined = any_ && t_s > before_s_ && t_s - before_s_ < longest_gap_s;
  for (; reading_ < readings.t_s.size() && readings.t_s[reading_] <= t_s; ++reading_) {
    const double at = readings.t_s[reading_];
    if (!joined || at < before_s_) continue;
    const double share = (at - before_s_) / (t_s - before_s_);
    residuals.t_s.push_back(at - m.t_s.front());
    residuals.nm.push_back(readings.torque_nm[reading_] - before_nm_ -
                           share * (torque_nm - before_nm_));
  }
  before_s_ = t_s, before_nm_ = torque_nm, any_ = true;
}

}  // namespace searig::app
