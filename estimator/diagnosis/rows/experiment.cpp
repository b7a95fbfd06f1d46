#include "estimator/diagnosis/rows/experiment.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "estimator/diagnosis/rows/reduced_motion.h"
#include "estimator/diagnosis/rows/row_worth.h"
#include "estimator/model/predict.h"
#include "estimator/order.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

constexpr double shortest_part_s = 25.0;     // a zero must outlast the blocks that are held out
constexpr double loadcell_limit_hz = 100.0;  // faster load cells: every n-th sample, as measured

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
    for (double t = Experiment::edge_s; t < e.motion.t.back() - Experiment::edge_s;
         t += e.drive_width_s)
      e.drive_t.push_back(t);
  } else {
    e.drive_width_s = e.loadcell_width_s;
    e.drive_t = e.loadcell_t;
  }
  e.at_drive = Sampler(e.motion.t, e.drive_t, e.drive_width_s);
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
  e.motion = reduced_motion(signals);
  e.motion.smoothing_rad_s = smoothing_rad_s;
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
