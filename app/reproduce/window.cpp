#include "app/reproduce/window.h"

#include <cmath>
#include <limits>

#include "estimator/model/predict.h"

namespace searig::app::reproduce {

Window window_of(const Trial& trial, const estimator::Evaluation& evaluation, double seconds) {
  const double start_s = trial.signals.module.t_s.front();
  Window out;
  for (const auto& estimate : evaluation.online->track) {
    const double t_s = estimate.t_s - start_s;
    if (t_s > seconds) break;
    out.t_s.push_back(t_s);
    out.weight.push_back(estimate.weight);
    out.current_nm.push_back(estimate.drive_nm);
    out.online_nm.push_back(estimate.torque_nm);
    out.stiffness_nm_per_rad.push_back(estimate.k_nm_per_rad);
  }
  const auto& loadcell = trial.signals.loadcell;
  for (std::size_t i = 0; i < loadcell.t_s.size(); ++i) {
    const double t_s = loadcell.t_s[i] - start_s;
    if (t_s < 0.0 || t_s > seconds) continue;
    out.measured_t_s.push_back(t_s);
    out.measured_nm.push_back(loadcell.torque_nm[i]);
  }
  out.measured_current_nm = estimator::sample_at(out.t_s, out.current_nm, out.measured_t_s);
  out.measured_online_nm = estimator::sample_at(out.t_s, out.online_nm, out.measured_t_s);
  for (std::size_t i = 0; i < out.measured_nm.size(); ++i) {
    out.current_error_nm.push_back(out.measured_current_nm[i] - out.measured_nm[i]);
    out.online_error_nm.push_back(out.measured_online_nm[i] - out.measured_nm[i]);
  }
  return out;
}

double settled_s(const Window& window, double k, double share) {
  for (std::size_t i = window.t_s.size(); i-- > 0;) {
    if (std::abs(window.stiffness_nm_per_rad[i] / k - 1.0) <= share) continue;
    return i + 1 < window.t_s.size() ? window.t_s[i + 1] : std::numeric_limits<double>::infinity();
  }
  return 0.0;
}

double error_percent(const Window& window, const std::vector<double>& error_nm, double from_s) {
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < error_nm.size(); ++i) {
    if (window.measured_t_s[i] < from_s) continue;
    error += std::abs(error_nm[i]);
    size += std::abs(window.measured_nm[i]);
  }
  return 100.0 * error / size;
}

}  // namespace searig::app::reproduce
