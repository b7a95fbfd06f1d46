#include "estimator/diagnosis/locate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "estimator/diagnosis/regression.h"

namespace searig::estimator {
namespace {

constexpr double region_share = 0.8;    // of the energy that a region holds
constexpr double interval_share = 0.9;  // and the seconds together

/// Change of each usable row's prediction, squared, in units of the noise.
Eigen::VectorXd energy(const Bench& bench, const Hypothesis& without, const Hypothesis& with) {
  const Eigen::VectorXd a = bench.raw_residual(without, bench.fit(without));
  const Eigen::VectorXd b = bench.raw_residual(with, bench.fit(with));
  const Experiment& e = bench.experiment();
  Eigen::VectorXd out = Eigen::VectorXd::Zero(e.rows());
  const double sd[2] = {bench.whitening().loadcell().sd, bench.whitening().drive().sd};
  for (Eigen::Index i = 0; i < e.rows(); ++i) {
    const double scale = sd[i < e.loadcell_rows() ? 0 : 1];
    if (e.usable[std::size_t(i)]) out[i] = std::pow((a[i] - b[i]) / scale, 2);
  }
  return out;
}

/// The part of a channel's range, in cells of equal width, that holds most of the energy per row.
std::vector<Region> regions(const Experiment& e, const Eigen::VectorXd& energy,
                            const std::string& channel) {
  const auto* values = channel_of(e.motion, channel);
  if (!values) return {};
  const Eigen::Map<const Eigen::VectorXd> x(values->data(), Eigen::Index(values->size()));
  Eigen::VectorXd at_rows(e.rows());
  if (e.loadcell_rows() > 0) at_rows.head(e.loadcell_rows()) = e.at_loadcell(x);
  if (e.drive_rows() > 0) at_rows.tail(e.drive_rows()) = e.at_drive(x);
  constexpr int cells = 40;
  const double low = x.minCoeff(), high = x.maxCoeff();
  if (!(high > low)) return {};
  std::vector<double> sum(cells, 0.0);
  for (Eigen::Index i = 0; i < e.rows(); ++i)
    sum[std::size_t(std::clamp(int(cells * (at_rows[i] - low) / (high - low)), 0, cells - 1))] +=
        energy[i];
  std::vector<std::size_t> order(cells);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, std::greater{}, [&](std::size_t c) { return sum[c]; });
  std::vector<bool> chosen(cells, false);
  double held = 0.0;
  for (const std::size_t c : order) {
    if (held >= region_share * energy.sum()) break;
    held += sum[c];
    chosen[c] = true;
  }
  std::vector<Region> out;
  const auto border = [&](std::size_t c) { return low + (high - low) * double(c) / cells; };
  for (std::size_t c = 0; c < cells; ++c) {
    if (!chosen[c]) continue;
    if (c > 0 && chosen[c - 1])
      out.back().to = border(c + 1);
    else
      out.push_back({channel, border(c), border(c + 1)});
  }
  return out;
}

/// The seconds, few of them, that hold most of the energy; neighbours merge.
std::vector<std::pair<double, double>> intervals(const Experiment& e,
                                                 const Eigen::VectorXd& energy) {
  const auto seconds = std::size_t(std::ceil(e.motion.t.back())) + 1;
  std::vector<double> sum(seconds, 0.0);
  for (Eigen::Index i = 0; i < e.rows(); ++i)
    sum[std::size_t(std::clamp(e.time(i), 0.0, double(seconds) - 1.0))] += energy[i];
  std::vector<std::size_t> order(seconds);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::sort(order, std::greater{}, [&](std::size_t s) { return sum[s]; });
  std::vector<bool> chosen(seconds, false);
  double held = 0.0;
  for (const std::size_t s : order) {
    if (held >= interval_share * energy.sum()) break;
    held += sum[s];
    chosen[s] = true;
  }
  std::vector<std::pair<double, double>> out;
  for (std::size_t s = 0; s < seconds; ++s) {
    if (!chosen[s]) continue;
    const double from = e.start_s + double(s);
    const double to = e.start_s + std::min(double(s + 1), e.motion.t.back());
    if (!out.empty() && from - out.back().second <= 1.5)
      out.back().second = to;
    else
      out.emplace_back(from, to);
  }
  return out;
}

}  // namespace

std::vector<std::string> residuals_of(Path path) {
  switch (path) {
    case Path::spring:
      return {"loadcell-spring", "drive-spring"};
    case Path::drive:
      return {"loadcell-drive", "drive-spring"};
    case Path::rig:
    case Path::observation:
      return {"loadcell-spring", "loadcell-drive"};
  }
  return {};
}

Located locate(const Bench& bench, const Hypothesis& without, const Hypothesis& with, Path path,
               const std::string& channel) {
  const Eigen::VectorXd lost = energy(bench, without, with);
  Located out;
  out.residuals = residuals_of(path);
  out.regions = regions(bench.experiment(), lost, channel);
  out.intervals_s = intervals(bench.experiment(), lost);
  return out;
}

std::vector<Cell> map_of(const Bench& bench, const std::vector<Atom>& dense,
                         const Hypothesis& before, const Hypothesis& after) {
  const Fit fits[2] = {bench.fit(before), bench.fit(after)};
  const Projection projections[2] = {{fits[0].columns, bench.right()},
                                     {fits[1].columns, bench.right()}};
  std::vector<Cell> out;
  for (const auto& atom : dense) {
    const Eigen::MatrixXd column = bench.screening_columns({nullptr, {}, &atom});
    double score[2];
    for (int i = 0; i < 2; ++i) {
      const auto gain = projections[i].gain(column);
      score[i] = std::copysign(std::sqrt(std::max(0.0, gain.sse)), gain.coefficients[0]);
    }
    out.push_back(
        {residuals_of(atom.path)[0], {atom.channel, atom.from, atom.to}, score[0], score[1]});
  }
  return out;
}

}  // namespace searig::estimator
