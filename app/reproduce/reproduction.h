// All trials, and what they say together: Table I and the targets.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/reproduce/trial.h"
#include "estimator/twin/bench.h"

namespace searig::app::reproduce {

/// Figure 3: strokes that reach 6 N*m on the unworn spring; the paper gives neither their size nor
/// their number.
constexpr double figure_3_amplitude_rad = 0.13, figure_3_hz = 0.5;
constexpr int figure_3_cycles = 40;

struct Settings {
  int seeds = 30;     ///< trials 1 .. seeds; the figures show trial 1
  unsigned jobs = 0;  ///< at the same time; 0: one for each core
  Protocol protocol = {};
};

struct Reproduction {
  Settings settings;
  std::vector<Variant> variants;
  std::vector<TrialFigures> trials;      ///< with a hand that holds against the module
  std::vector<TrialFigures> dragged;     ///< the same with a hand that drags it along
  Trial shown;                           ///< the first trial, whichever it is
  estimator::twin::SpringCycles cycles;  ///< of figure 3
};

/// A number over the trials.
struct Spread {
  double mean = 0, sd = 0, least = 0, most = 0;
};
Spread spread_of(const std::vector<double>& values);

/// A row of Table I; errors in percent.
struct Row {
  std::string key, name;
  std::optional<double> paper;  ///< what the paper's Table I says
  std::vector<double> trials;   ///< one error for each
};
std::vector<Row> table_1(const Reproduction& all, const std::vector<TrialFigures>& trials);

/// How one variant stands to what is asked of it.
struct Targets {
  double over_best_fit = 0;  ///< mean error over the best fit's; at most 1.2
  int within_best_fit = 0;   ///< trials in which that holds by itself
  double over_current = 0;   ///< mean error over the motor current's; at most 0.5
  int within_current = 0;
  int reached = 0;                ///< trials in which the trust weight summed to 5 s
  int close = 0;                  ///< of those, within 5 % of the best fit at that moment
  double median_off_percent = 0;  ///< of the best fit at that moment, in magnitude
  double worst_off_percent = 0;
  double mean_off_percent = 0;      ///< with its sign
  double loadcell_off_percent = 0;  ///< mean, with its sign: Approach::loadcell_off_percent
  double within_later_percent = 0;  ///< mean share of the time from then on within 5 %
};
constexpr double most_over_best_fit = 1.2, most_over_current = 0.5;
Targets targets(const std::vector<TrialFigures>& trials, std::size_t variant);

/// progress(share) is called now and then from any thread, one call at a time. Throws
/// std::runtime_error with one sentence where a trial fails.
Reproduction reproduce(const Settings& settings, const std::function<void(double)>& progress);

}  // namespace searig::app::reproduce
