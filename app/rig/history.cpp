#include "app/rig/history.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "estimator/model/predict.h"

namespace searig::app {
namespace {

constexpr std::array track_columns{
    &History::t_s,    &History::estimated_nm,         &History::current_nm,
    &History::weight, &History::stiffness_nm_per_rad, &History::stiffness_sd_nm_per_rad};

std::vector<double> since(double start_s, const std::vector<double>& t_s) {
  std::vector<double> out(t_s);
  for (double& t : out) t -= start_s;
  return out;
}

}  // namespace

void History::append(const estimator::OnlineEstimate& estimate, double start_s) {
  t_s.push_back(estimate.t_s - start_s);
  estimated_nm.push_back(estimate.torque_nm);
  current_nm.push_back(estimate.drive_nm);
  weight.push_back(estimate.weight);
  stiffness_nm_per_rad.push_back(estimate.k_nm_per_rad);
  stiffness_sd_nm_per_rad.push_back(std::sqrt(estimate.variance));
}

void History::append(const History& more) {
  for (const auto column : track_columns) {
    auto& to = this->*column;
    to.insert(to.end(), (more.*column).begin(), (more.*column).end());
  }
}

void History::reserve(std::size_t samples) {
  for (const auto column : track_columns) (this->*column).reserve(samples);
}

void History::set_measured(const estimator::LoadcellSignals& loadcell, double start_s) {
  measured_t_s = since(start_s, loadcell.t_s);
  measured_nm = loadcell.torque_nm;
}

History history_of(const estimator::Signals& signals, const estimator::Evaluation& evaluation) {
  History history;
  const auto& module = signals.module;
  if (module.t_s.empty()) return history;
  const double start_s = module.t_s.front();
  history.set_measured(signals.loadcell, start_s);
  if (evaluation.online) {
    for (const auto& estimate : evaluation.online->track) history.append(estimate, start_s);
  } else if (evaluation.best_fit) {
    history.estimated_from = "best fit of the spring";
    history.t_s = since(start_s, module.t_s);
    for (const double theta : module.deflection_rad) {
      history.estimated_nm.push_back(evaluation.best_fit->k_nm_per_rad * theta +
                                     evaluation.best_fit->offset_nm);
    }
  } else if (evaluation.current) {
    history.estimated_from = "motor current";
    history.t_s = since(start_s, module.t_s);
    for (const double current : module.current_a) {
      history.estimated_nm.push_back(evaluation.current->gain_nm_per_a * current +
                                     evaluation.current->offset_nm);
    }
  }
  return history;
}

std::optional<double> error_percent(const History& history, double from_s) {
  if (history.t_s.empty()) return std::nullopt;
  const auto estimated =
      estimator::sample_at(history.t_s, history.estimated_nm, history.measured_t_s);
  double error = 0.0, size = 0.0;
  for (std::size_t i = 0; i < history.measured_t_s.size(); ++i) {
    const double t = history.measured_t_s[i];
    if (t < std::max(from_s, history.t_s.front()) || t > history.t_s.back()) continue;
    error += std::abs(estimated[i] - history.measured_nm[i]);
    size += std::abs(history.measured_nm[i]);
  }
  if (!(size > 0.0)) return std::nullopt;
  return 100.0 * error / size;
}

}  // namespace searig::app
