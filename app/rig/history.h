// An experiment as a view or a report shows it: each column ready for a plot.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimator/evaluation/evaluation.h"
#include "estimator/filter/online_stiffness.h"
#include "estimator/signals.h"

namespace searig::app {

/// Times are seconds since the first telemetry.
struct History {
  std::vector<double> t_s;
  std::vector<double> estimated_nm;  ///< k*theta with the k of that moment
  std::string estimated_from = "estimated online from the spring";  ///< for a legend
  std::vector<double> current_nm;                                   ///< what the motor current says
  std::vector<double> weight;                   ///< trust in the motor current, 0..1
  std::vector<double> stiffness_nm_per_rad;     ///< empty where none could be estimated
  std::vector<double> stiffness_sd_nm_per_rad;  ///< the filter's own; no confidence interval
  std::vector<double> measured_t_s;             ///< of the load cell, on the module's clock
  std::vector<double> measured_nm;

  void append(const estimator::OnlineEstimate& estimate, double start_s);
  void append(const History& more);  ///< but for what was measured
  void reserve(std::size_t samples);
  void set_measured(const estimator::LoadcellSignals& loadcell, double start_s);
};

/// What an evaluation found over a whole recording. Where it has no online estimate, the torque is
/// that of the best fit, or without a spring that of the motor current alone; weight and stiffness
/// are empty.
History history_of(const estimator::Signals& signals, const estimator::Evaluation& evaluation);

/// mean |estimated - measured| over mean |measured|, in percent, from `from_s` on; nothing where
/// nothing can be compared.
std::optional<double> error_percent(const History& history, double from_s = 0.0);

}  // namespace searig::app
