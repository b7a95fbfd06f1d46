#include "estimator/diagnosis/answer/remainder.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/answer/locate.h"
#include "estimator/order.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

constexpr double loud = 3.0;  // times what is expected: slow noise alone reaches two now and then
constexpr double least_seconds = 3.0;

struct Second {
  double begins_s, loudness, load;  // medians of |residual| and of |torque| or |speed|
};

std::vector<Second> seconds_of(const Bench& bench, const Eigen::VectorXd& residual,
                               const Eigen::VectorXd& load, Eigen::Index from, Eigen::Index to) {
  const Experiment& e = bench.experiment();
  std::vector<Second> out;
  std::vector<double> r, l;
  double second = -1.0;
  const auto close = [&] {
    if (r.size() >= 8) out.push_back({second, median(r), median(l)});
    r.clear(), l.clear();
  };
  for (Eigen::Index i = from; i < to; ++i) {
    if (!e.usable[std::size_t(i)]) continue;
    if (std::floor(e.time(i)) != second) close(), second = std::floor(e.time(i));
    r.push_back(std::abs(residual[i]));
    l.push_back(std::abs(load[i]));
  }
  close();
  return out;
}

/// Loudness that the load explains: a straight line through the quieter two thirds.
std::vector<double> expected(const std::vector<Second>& all) {
  std::vector<double> loudness;
  for (const auto& s : all) loudness.push_back(s.loudness);
  const double usual = median(loudness);
  Eigen::Matrix2d normal = Eigen::Matrix2d::Identity() * 1e-12;
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const auto& s : all) {
    if (s.loudness > 2.0 * usual) continue;
    const Eigen::Vector2d x(1.0, s.load);
    normal += x * x.transpose();
    right += x * s.loudness;
  }
  const Eigen::Vector2d line = normal.ldlt().solve(right);
  std::vector<double> out;
  for (const auto& s : all)
    out.push_back(std::max(0.7 * usual, line[0] + std::max(0.0, line[1]) * s.load));
  return out;
}

std::vector<std::pair<double, double>> loud_intervals(const std::vector<Second>& all) {
  std::vector<std::pair<double, double>> out;
  if (all.size() < 10) return out;
  const auto usual = expected(all);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].loudness < loud * usual[i]) continue;
    if (!out.empty() && all[i].begins_s - out.back().second < 0.5)
      out.back().second = all[i].begins_s + 1.0;
    else
      out.emplace_back(all[i].begins_s, all[i].begins_s + 1.0);
  }
  std::erase_if(out, [](const auto& i) { return i.second - i.first < least_seconds; });
  return out;
}

}  // namespace

std::optional<Unexplained> loud_while(const Bench& bench, const Hypothesis& hypothesis) {
  const Experiment& e = bench.experiment();
  const Eigen::VectorXd raw = bench.raw_residual(hypothesis);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(e.rows());
  load.head(e.loadcell_rows()) = e.loadcell_nm.head(e.loadcell_rows());
  if (e.has_drive()) load.tail(e.drive_rows()) = e.at_drive(as_array(e.motion.w).matrix());
  const Eigen::Index borders[3] = {0, e.loadcell_rows(), e.rows()};
  for (int block = 0; block < 2; ++block) {
    const auto found =
        loud_intervals(seconds_of(bench, raw, load, borders[block], borders[block + 1]));
    double length = 0.0;
    for (const auto& [from, to] : found) length += to - from;
    if (found.empty() || length > 0.4 * e.motion.t.back()) continue;
    Unexplained out;
    out.located.residuals = residuals_of(block == 0 ? Path::rig : Path::drive);
    for (const auto& [from, to] : found)
      out.located.intervals_s.emplace_back(e.start_s + from, e.start_s + to);
    // A row is three times beyond the median with a chance of 0.043; that half of n rows are, by
    // Chernoff's bound, with one of (4*0.043*0.957)^(n/2). Slow noise has fewer rows to count, by
    // (1 - r)/(1 + r) for a correlation of r between neighbours. Bonferroni over the seconds.
    const Autoregression& noise =
        block == 0 ? bench.whitening().loadcell() : bench.whitening().drive();
    const double r = std::clamp(noise.phi.sum(), 0.0, 0.98);
    const double rows = double(borders[block + 1] - borders[block]) / e.motion.t.back();
    const double free_rows = rows * length * (1.0 - r) / (1.0 + r);
    out.p_value = std::min(1.0, e.motion.t.back() * std::pow(0.165, 0.5 * free_rows));
    if (out.p_value > 0.01) continue;
    out.what = "something shakes for a while";
    return out;
  }
  return std::nullopt;
}

}  // namespace searig::estimator
