#include "estimator/evaluation/evaluation.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <stdexcept>

#include "estimator/evaluation/compare_estimators.h"
#include "estimator/evaluation/loop_error.h"
#include "estimator/evaluation/online_result.h"
#include "estimator/model/predict.h"
#include "estimator/order.h"

namespace searig::estimator {

namespace {

constexpr double longest_gap = 10;  // telemetry intervals over which to interpolate

// Whether t is one of the telemetry's times or lies between two that are close to each other.
bool covered(const std::vector<double>& telemetry, double t, double longest_s) {
  const auto after = std::lower_bound(telemetry.begin(), telemetry.end(), t);
  if (after == telemetry.end()) return false;
  return *after == t || (after != telemetry.begin() && *after - *(after - 1) <= longest_s);
}

// Without the load-cell samples that are no numbers or that no telemetry covers.
Signals where_covered(Signals signals) {
  const auto& telemetry = signals.module.t_s;
  if (telemetry.size() < 2) return signals;
  const double longest_s = longest_gap * median_step(telemetry);
  auto& [t, torque] = signals.loadcell;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (!std::isfinite(torque[i]) || !covered(telemetry, t[i], longest_s)) continue;
    t[kept] = t[i];
    torque[kept++] = torque[i];
  }
  t.resize(kept);
  torque.resize(kept);
  return signals;
}

void check(const Signals& signals) {
  if (signals.module.t_s.size() < 5) {
    throw std::invalid_argument("the recording holds fewer than five samples of the module");
  }
  if (signals.loadcell.t_s.size() < 5) {
    throw std::invalid_argument(
        "fewer than five load-cell samples lie within the module's telemetry");
  }
  if (signals.module.deflection_rad.empty() && signals.module.current_a.empty()) {
    throw std::invalid_argument(
        "the module has neither deflection nor current: nothing to hold against the load cell");
  }
}

std::optional<BestFit> best_fit(const Signals& signals) {
  const auto theta =
      sample_at(signals.module.t_s, signals.module.deflection_rad, signals.loadcell.t_s);
  const Line line = fit_line(theta, signals.loadcell.torque_nm);
  if (!std::isfinite(line.slope)) return std::nullopt;
  std::vector<double> estimate(theta.size());
  for (std::size_t i = 0; i < theta.size(); ++i) estimate[i] = line.slope * theta[i] + line.offset;
  return BestFit{line.slope, line.offset, score(estimate, signals.loadcell.torque_nm)};
}

CurrentResult motor_current(const Signals& signals, const DriveTorque& drive) {
  auto estimate = sample_at(signals.module.t_s, drive.nm, signals.loadcell.t_s);
  for (double& torque : estimate) torque += drive.offset_nm;
  return {drive.gain_nm_per_a, drive.offset_nm, score(estimate, signals.loadcell.torque_nm)};
}

void evaluate_spring(const Signals& signals, Evaluation& out) {
  if (signals.module.deflection_rad.empty()) {
    out.notes.push_back("no deflection: best fit and online estimate are switched off");
    return;
  }
  out.best_fit = best_fit(signals);
  if (!out.best_fit) {
    out.notes.push_back("the deflection never changes: best fit is switched off");
  } else if (out.best_fit->k_nm_per_rad <= 0) {
    out.notes.push_back(
        "the measured torque falls as the deflection grows: one of their signs is wrong, which "
        "scale = -1 in recording.toml mends");
  }
}

void evaluate_current(const Signals& signals, const DriveTorque& drive, Evaluation& out) {
  if (signals.module.current_a.empty()) {
    out.notes.push_back("no motor current: motor current and online estimate are switched off");
  } else if (drive.nm.empty()) {
    out.notes.push_back("the motor current never changes: it cannot be held against the load cell");
  } else {
    out.drive_from = drive.from;
    out.drive_independent = !drive.fitted;
    out.current = motor_current(signals, drive);
  }
}

}  // namespace

Evaluation evaluate(const Signals& recorded, const Model* model, const EvaluationOptions& options) {
  Signals signals = where_covered(recorded);
  Evaluation out;
  const bool by_loop = options.drive == DriveTerms::loop;
  if (by_loop) {
    const auto missing = take_loop_error_for_current(signals, options.loop_gain_a_per_rad);
    if (missing) out.notes.push_back(*missing);
  }
  check(signals);
  const bool knows_amperes = !by_loop || options.loop_gain_a_per_rad;
  const DriveTorque drive = drive_torque(signals, knows_amperes ? model : nullptr, options.drive);
  if (const auto left_out = recorded.loadcell.t_s.size() - signals.loadcell.t_s.size()) {
    out.notes.push_back(std::to_string(left_out) +
                        " load-cell samples are left out: no telemetry at their time");
  }
  out.seconds = signals.module.t_s.back() - signals.module.t_s.front();
  evaluate_spring(signals, out);
  evaluate_current(signals, drive, out);
  if (!signals.module.deflection_rad.empty() && !drive.nm.empty()) {
    out.online = follow_online(signals, model, drive, options, out.best_fit, out.notes);
  }
  if (out.online) {
    out.estimators = compare_estimators(signals, model, drive, options, *out.online, out.notes);
  }
  return out;
}

}  // namespace searig::estimator
