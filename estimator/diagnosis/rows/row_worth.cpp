#include "estimator/diagnosis/rows/row_worth.h"

#include <algorithm>
#include <cmath>

#include "estimator/model/predict.h"
#include "estimator/order.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

/// A sample that stands apart from its neighbours by six times what samples usually do.
std::vector<bool> spikes(const Eigen::VectorXd& x) {
  const auto n = std::size_t(x.size());
  std::vector<double> apart(n, 0.0);
  for (std::size_t i = 2; i + 2 < n; ++i) {
    const auto k = Eigen::Index(i);
    // Third difference's kin: what a cubic through the neighbours does not predict.
    apart[i] = std::abs(x[k] - (4.0 * (x[k - 1] + x[k + 1]) - (x[k - 2] + x[k + 2])) / 6.0);
  }
  const double limit = 6.0 * 1.4826 * median(apart);
  std::vector<bool> out(n, false);
  for (std::size_t i = 2; i + 2 < n; ++i)
    out[i] = apart[i] > limit && apart[i] >= apart[i - 1] && apart[i] >= apart[i + 1];
  // Many of them close together are no spikes but something that shakes.
  std::vector<bool> alone = out;
  constexpr std::size_t reach = 25;
  for (std::size_t i = reach; i + reach < n; ++i)
    if (out[i] && std::count(out.begin() + std::ptrdiff_t(i - reach),
                             out.begin() + std::ptrdiff_t(i + reach), true) > 4)
      alone[i] = false;
  return alone;
}

/// Whether the input moves throughout the window around each row, one way.
std::vector<bool> moving(const Motion& m, const std::vector<double>& at, double width_s) {
  std::vector<bool> out;
  std::size_t i = 0;
  for (const double centre : at) {
    while (i + 1 < m.size() && m.t[i] < centre - width_s) ++i;
    bool one_way = true;
    for (std::size_t j = i; j < m.size() && m.t[j] <= centre + width_s; ++j)
      one_way = one_way && std::abs(m.w[j]) > moving_rad_s && m.w[j] * m.w[i] > 0;
    out.push_back(one_way);
  }
  return out;
}

/// Smallest step that an angle channel takes: what its encoder resolves, or less if it is smoothed.
double quantum(const std::vector<double>& x) {
  std::vector<double> step;
  for (std::size_t i = 1; i < x.size(); ++i)
    if (x[i] != x[i - 1]) step.push_back(std::abs(x[i] - x[i - 1]));
  if (step.empty()) return 0.0;
  const auto at = step.begin() + std::ptrdiff_t(step.size() / 20);
  std::ranges::nth_element(step, at);
  return *at;
}

}  // namespace

void mark_usable(Experiment& e) {
  const double gap_s = 5.0 * median_step(e.motion.t);
  const auto spike = spikes(e.loadcell_nm);
  if (e.has_spring()) {
    const auto covered = e.at_loadcell.covered(gap_s);
    for (std::size_t i = 0; i < covered.size(); ++i)
      e.usable.push_back(covered[i] && !spike[i] && e.loadcell_t[i] > Experiment::edge_s &&
                         e.loadcell_t[i] < e.motion.t.back() - Experiment::edge_s);
  }
  if (!e.has_drive()) return;
  const auto covered = e.at_drive.covered(gap_s);
  // One way as far as the current's filter reaches, which smears the jump of friction at a
  // reversal.
  const double reach_s =
      e.has_spring() ? e.drive_width_s / 2 + differentiator_half_width_s : e.drive_width_s;
  const auto moves = moving(e.motion, e.drive_t, reach_s);
  for (std::size_t i = 0; i < covered.size(); ++i)
    e.usable.push_back(covered[i] && moves[i] && (e.has_spring() || !spike[i]));
}

void weigh_holds(Experiment& e, const ModuleSignals& module) {
  e.weight.assign(std::size_t(e.rows()), 1.0);
  if (!e.has_spring()) return;
  const auto& m = e.motion;
  double q = quantum(module.deflection_rad);
  if (!module.input_angle_rad.empty())
    q = std::hypot(quantum(module.input_angle_rad), quantum(module.output_angle_rad));
  const Eigen::VectorXd theta = e.at_loadcell(as_array(m.theta).matrix());
  const double k = e.loadcell_nm.dot(theta) / std::max(theta.squaredNorm(), 1e-30);
  const Eigen::Index n = e.loadcell_rows();
  std::vector<double> apart;  // neighbouring samples, while nothing happens
  for (Eigen::Index i = 1; i + 1 < n; ++i)
    apart.push_back(
        std::abs(e.loadcell_nm[i] - 0.5 * (e.loadcell_nm[i - 1] + e.loadcell_nm[i + 1])));
  const double noise = std::max(1.2 * median(std::move(apart)), 1e-12);
  const double error = std::abs(k) * q / std::sqrt(12.0);
  for (Eigen::Index from = 0; from < n;) {
    Eigen::Index to = from + 1;
    while (to < n && std::abs(theta[to] - theta[from]) < 0.5 * q) ++to;
    const double worth = 1.0 / std::sqrt(1.0 + double(to - from - 1) * std::pow(error / noise, 2));
    for (; from < to; ++from) e.weight[std::size_t(from)] = worth;
  }
}

}  // namespace searig::estimator
