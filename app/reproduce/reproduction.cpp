#include "app/reproduce/reproduction.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <numeric>
#include <stdexcept>

#include "app/in_parallel.h"
#include "estimator/evaluation/score.h"
#include "estimator/twin/paper_module.h"

namespace searig::app::reproduce {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return std::nan("");
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

double mean(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

template <class Pick>
std::vector<double> each(const std::vector<TrialFigures>& trials, Pick pick) {
  std::vector<double> out;
  for (const auto& trial : trials) out.push_back(pick(trial));
  return out;
}

/// The paper, section VII: "Averaging spring stiffnesses from other trials does not work as well".
std::vector<double> errors_of_others_stiffness(const std::vector<TrialFigures>& trials) {
  double sum = 0;
  for (const auto& trial : trials) sum += trial.best_fit_k_nm_per_rad;
  return each(trials, [&](const TrialFigures& trial) {
    const double k = (sum - trial.best_fit_k_nm_per_rad) / static_cast<double>(trials.size() - 1);
    std::vector<double> estimate(trial.deflection_rad);
    for (double& torque : estimate) torque *= k;
    return estimator::score(estimate, trial.measured_nm).error_percent;
  });
}

}  // namespace

Spread spread_of(const std::vector<double>& values) {
  Spread out{mean(values), 0, values.front(), values.front()};
  for (const double value : values) {
    out.sd += (value - out.mean) * (value - out.mean);
    out.least = std::min(out.least, value);
    out.most = std::max(out.most, value);
  }
  const auto n = static_cast<double>(values.size());
  out.sd = n > 1 ? std::sqrt(out.sd / (n - 1)) : 0.0;
  return out;
}

std::vector<Row> table_1(const Reproduction& all, const std::vector<TrialFigures>& trials) {
  const auto error_of = [&](auto pick) {
    return each(trials, [pick](const TrialFigures& t) { return pick(t).error_percent; });
  };
  std::vector<Row> rows;
  rows.push_back({"best_fit", "Linear (best fit)", 7.0,
                  error_of([](const TrialFigures& t) { return t.best_fit; })});
  for (std::size_t v = 0; v < all.variants.size(); ++v) {
    rows.push_back({"online_" + all.variants[v].key, all.variants[v].name,
                    v == 0 ? std::optional(8.0) : std::nullopt,
                    error_of([v](const TrialFigures& t) { return t.online[v].good; })});
  }
  rows.push_back({"current", "Motor current, equation (2)", 21.0,
                  error_of([](const TrialFigures& t) { return t.current; })});
  if (trials.size() > 1) {
    rows.push_back({"others_stiffness", "Linear, mean stiffness of the other trials", std::nullopt,
                    errors_of_others_stiffness(trials)});
  }
  return rows;
}

Targets targets(const std::vector<TrialFigures>& trials, std::size_t variant) {
  Targets out;
  double online = 0, fit = 0, current = 0;
  std::vector<double> off;
  for (const auto& trial : trials) {
    const auto& [good, poor, last_k, approach] = trial.online[variant];
    online += good.error_percent;
    fit += trial.best_fit.error_percent;
    current += trial.current.error_percent;
    out.within_best_fit += good.error_percent <= most_over_best_fit * trial.best_fit.error_percent;
    out.within_current += good.error_percent <= most_over_current * trial.current.error_percent;
    if (!approach) continue;
    ++out.reached;
    off.push_back(std::abs(approach->off_percent));
    out.close += off.back() <= 5.0;
    out.mean_off_percent += approach->off_percent;
    out.loadcell_off_percent += approach->loadcell_off_percent;
    out.within_later_percent += approach->within_later_percent;
  }
  out.over_best_fit = online / fit;
  out.over_current = online / current;
  out.median_off_percent = median(off);
  out.worst_off_percent = off.empty() ? std::nan("") : *std::ranges::max_element(off);
  for (double* sum :
       {&out.mean_off_percent, &out.loadcell_off_percent, &out.within_later_percent}) {
    *sum /= out.reached;
  }
  return out;
}

Reproduction reproduce(const Settings& settings, const std::function<void(double)>& progress) {
  Reproduction out;
  out.settings = settings;
  out.variants = variants(settings.protocol);
  const auto seeds = static_cast<std::size_t>(settings.seeds);
  out.trials.resize(seeds);
  out.dragged.resize(seeds);
  std::mutex guard;  // of what follows
  std::size_t done = 0;
  std::string failure;
  in_parallel(2 * seeds, settings.jobs, [&](std::size_t item) {
    const std::size_t i = item / 2;
    const Hand hand = item % 2 == 0 ? Hand::holds_against : Hand::drags_along;
    try {
      Trial trial = run_trial(i + 1, hand, settings.protocol, out.variants);
      (item % 2 == 0 ? out.trials : out.dragged)[i] = trial.figures;
      if (item == 0) out.shown = std::move(trial);
    } catch (const std::exception& error) {
      const std::lock_guard lock(guard);
      failure = error.what();
    }
    const std::lock_guard lock(guard);
    progress(static_cast<double>(++done) / static_cast<double>(2 * seeds));
  });
  if (!failure.empty()) throw std::runtime_error(failure);
  out.cycles = estimator::twin::cycle_spring(estimator::twin::nominal_paper_module().spring,
                                             figure_3_amplitude_rad, figure_3_hz, figure_3_cycles);
  return out;
}

}  // namespace searig::app::reproduce
