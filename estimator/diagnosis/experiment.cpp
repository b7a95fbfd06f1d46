#include "estimator/diagnosis/experiment.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "estimator/kinematics.h"
#include "estimator/model/predict.h"
#include "estimator/order.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

constexpr double half_width_s = 0.024;  // of the differentiator
constexpr double rate_limit_hz = 300.0;
constexpr double edge_s = 0.1;
constexpr double shortest_part_s = 25.0;     // a zero must outlast the blocks that are held out
constexpr double loadcell_limit_hz = 100.0;  // faster load cells: every n-th sample, as measured

double range(const std::vector<double>& x) {
  const auto [low, high] = std::ranges::minmax_element(x);
  return x.empty() ? 0.0 : *high - *low;
}

void thin_out(Motion& m, std::size_t every) {
  const auto thin = [every](std::vector<double>& x) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < x.size(); i += every) x[kept++] = x[i];
    x.resize(kept);
  };
  for (auto* x : {&m.t, &m.theta, &m.theta_rate, &m.theta_accel, &m.q_i, &m.w, &m.a, &m.q_o, &m.w_o,
                  &m.a_o, &m.current, &m.winding_c, &m.spring_c})
    thin(*x);
}

/// Over the samples that thinning would drop.
void average(std::vector<double>& x, std::size_t every) {
  if (every < 2 || x.empty()) return;
  std::vector<double> sum(x.size() + 1, 0.0);
  for (std::size_t i = 0; i < x.size(); ++i) sum[i + 1] = sum[i] + x[i];
  for (std::size_t i = 0; i < x.size(); ++i) {
    const std::size_t from = i - std::min(i, every / 2);
    const std::size_t to = std::min(x.size(), from + every + 1 - every % 2);
    x[i] = (sum[to] - sum[from]) / double(to - from);
  }
}

/// Where current is held against angles it passes the same filter as they: what one filter takes
/// from both sides of an equation does not look like inertia or friction. Held against a load cell,
/// which passes none, it is only averaged over what thinning would drop.
void filter_current(Motion& m, const std::vector<double>& t, std::size_t every) {
  if (m.has_spring() && !m.current.empty())
    m.current = differentiate(t, m.current, half_width_s).value;
  else
    average(m.current, every);
}

/// Rubber and windings warm over many seconds; what a temperature reads beyond that is its noise.
void calm_temperatures(Motion& m) {
  constexpr double window_s = 2.0;
  if (m.t.back() < 2.0 * window_s) return;
  std::vector<double> centres = m.t;
  for (double& t : centres) t = std::clamp(t, window_s / 2, m.t.back() - window_s / 2);
  const Sampler mean(m.t, centres, window_s);
  for (auto* x : {&m.winding_c, &m.spring_c}) {
    if (x->empty()) continue;
    const Eigen::VectorXd calm = mean(as_array(*x).matrix());
    x->assign(calm.begin(), calm.end());
  }
}

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

void lay_loadcell_rows(Experiment& e, const Signals& s) {
  const auto every = std::max<std::size_t>(
      1, std::size_t(1.0 / (median_step(s.loadcell.t_s) * loadcell_limit_hz)));
  std::vector<double> torque;
  for (std::size_t i = 0; i < s.loadcell.t_s.size(); i += every) {
    e.loadcell_t.push_back(s.loadcell.t_s[i] - e.start_s);
    torque.push_back(s.loadcell.torque_nm[i]);
  }
  const auto n = Eigen::Index(torque.size());
  e.loadcell_nm = Eigen::Map<const Eigen::VectorXd>(torque.data(), n);
  e.torque_rms = std::sqrt(e.loadcell_nm.squaredNorm() / double(std::max<Eigen::Index>(n, 1)));
  e.loadcell_width_s = std::min(0.02, median_step(e.loadcell_t));
  e.at_loadcell = Sampler(e.motion.t, e.loadcell_t, e.loadcell_width_s);
}

/// A first idea of the load on spring and gears. Where there is a spring it comes from the
/// deflection, so that nothing measured by the load cell is ever held against itself.
void guess_load(Experiment& e, const LoadcellSignals& loadcell) {
  Motion& m = e.motion;
  if (!m.has_spring()) {
    std::vector<double> t = loadcell.t_s;
    for (double& v : t) v -= e.start_s;
    m.spring_nm = sample_at(t, loadcell.torque_nm, m.t);
    return;
  }
  const Eigen::VectorXd theta = e.at_loadcell(as_array(m.theta).matrix());
  const Eigen::ArrayXd a = theta.array() - theta.mean();
  const double k = (a * e.loadcell_nm.array()).sum() / std::max(a.square().sum(), 1e-30);
  for (const double v : m.theta) m.spring_nm.push_back(k * v);
}

void lay_drive_rows(Experiment& e) {
  if (!e.motion.has_drive()) return;
  if (e.motion.has_spring()) {
    e.drive_width_s = std::max(0.02, 2.0 * median_step(e.motion.t));
    for (double t = edge_s; t < e.motion.t.back() - edge_s; t += e.drive_width_s)
      e.drive_t.push_back(t);
  } else {
    e.drive_width_s = e.loadcell_width_s;
    e.drive_t = e.loadcell_t;
  }
  e.at_drive = Sampler(e.motion.t, e.drive_t, e.drive_width_s);
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

/// While the deflection is held, the encoders' rounding does not average out: the whole hold has
/// one error of k*quantum/sqrt(12), and n rows of it are worth 1/(1 + n*error^2/noise^2) each.
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

void mark_usable(Experiment& e) {
  const double gap_s = 5.0 * median_step(e.motion.t);
  const auto spike = spikes(e.loadcell_nm);
  if (e.has_spring()) {
    const auto covered = e.at_loadcell.covered(gap_s);
    for (std::size_t i = 0; i < covered.size(); ++i)
      e.usable.push_back(covered[i] && !spike[i] && e.loadcell_t[i] > edge_s &&
                         e.loadcell_t[i] < e.motion.t.back() - edge_s);
  }
  if (!e.has_drive()) return;
  const auto covered = e.at_drive.covered(gap_s);
  // One way as far as the current's filter reaches, which smears the jump of friction at a
  // reversal.
  const double reach_s = e.has_spring() ? e.drive_width_s / 2 + half_width_s : e.drive_width_s;
  const auto moves = moving(e.motion, e.drive_t, reach_s);
  for (std::size_t i = 0; i < covered.size(); ++i)
    e.usable.push_back(covered[i] && moves[i] && (e.has_spring() || !spike[i]));
}

}  // namespace

double Experiment::time(Eigen::Index row) const {
  return row < loadcell_rows() ? loadcell_t[std::size_t(row)]
                               : drive_t[std::size_t(row - loadcell_rows())];
}

std::size_t Experiment::part(Eigen::Index row) const {
  const auto after = std::ranges::upper_bound(part_starts_s, time(row));
  return after == part_starts_s.begin() ? 0 : std::size_t(after - part_starts_s.begin()) - 1;
}

Experiment prepare(const Signals& signals, double smoothing_rad_s) {
  if (signals.module.t_s.size() < 100 || signals.loadcell.t_s.size() < 100)
    throw std::invalid_argument(
        "too short to diagnose: the module has " + std::to_string(signals.module.t_s.size()) +
        " samples and the load cell " + std::to_string(signals.loadcell.t_s.size()) +
        ", of at least 100 each");
  Experiment e;
  e.start_s = signals.module.t_s.front();
  e.motion = motion_of(signals.module, half_width_s);
  e.motion.smoothing_rad_s = smoothing_rad_s;
  e.motion.gear_ratio = signals.gear_ratio;
  // A clamped output moves by its encoder's rounding only: nothing can be said over its angle.
  if (range(e.motion.q_o) < 0.1 * range(e.motion.theta))
    e.motion.q_o.clear(), e.motion.w_o.clear(), e.motion.a_o.clear();
  const auto every = std::max<std::size_t>(
      1, std::size_t(std::lround(1.0 / (median_step(e.motion.t) * rate_limit_hz))));
  filter_current(e.motion, signals.module.t_s, every);
  thin_out(e.motion, every);
  calm_temperatures(e.motion);
  for (const double start : signals.part_starts_s)
    if (start - e.start_s >= e.part_starts_s.back() + shortest_part_s &&
        start + shortest_part_s <= signals.module.t_s.back())
      e.part_starts_s.push_back(start - e.start_s);
  e.clock_sd_s = signals.clock_ci95_s / 1.96;
  lay_loadcell_rows(e, signals);
  guess_load(e, signals.loadcell);
  lay_drive_rows(e);
  if (e.rows() == 0)
    throw std::invalid_argument(
        "nothing to compare: the module has neither a deflection nor a current with a velocity");
  mark_usable(e);
  weigh_holds(e, signals.module);
  e.measured = Eigen::VectorXd::Zero(e.rows());
  e.measured.head(e.has_spring() ? e.loadcell_rows() : e.rows()) = e.loadcell_nm;
  return e;
}

}  // namespace searig::estimator
