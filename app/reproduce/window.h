// The part of the shown trial that the paper's figures have room for, as their curves want it.
#pragma once

#include <vector>

#include "app/reproduce/reproduction.h"

namespace searig::app::reproduce {

/// Times are seconds since the first telemetry. One set of columns at the telemetry's samples, one
/// at the load cell's.
struct Window {
  std::vector<double> t_s, weight, current_nm, online_nm, stiffness_nm_per_rad;
  std::vector<double> measured_t_s, measured_nm, measured_current_nm, measured_online_nm;
  std::vector<double> current_error_nm, online_error_nm;  ///< at the load cell's samples
};

Window window_of(const Trial& trial, const estimator::Evaluation& evaluation, double seconds);

/// The first time from which on the stiffness stays within `share` of k; infinite where it does
/// not by the window's end.
double settled_s(const Window& window, double k, double share);

/// mean |error| over mean |measured| from `from_s` on, in percent.
double error_percent(const Window& window, const std::vector<double>& error_nm, double from_s);

}  // namespace searig::app::reproduce
