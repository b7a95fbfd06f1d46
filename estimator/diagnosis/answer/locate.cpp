#include "estimator/diagnosis/answer/locate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "estimator/diagnosis/fit/regression.h"

namespace searig::estimator {
namespace {

/// Change of each usable row's prediction, squared, in units of the noise.
Eigen::VectorXd energy(const Bench& bench, const Hypothesis& without, const Hypothesis& with) {
  const Experiment& e = bench.experiment();
  const Eigen::VectorXd change =
      bench.whitening()(bench.raw_residual(without) - bench.raw_residual(with));
  Eigen::VectorXd out = Eigen::VectorXd::Zero(e.rows());
  for (Eigen::Index i = 0; i < e.rows(); ++i)
    if (e.usable[std::size_t(i)]) out[i] = change[i] * change[i];
  return out;
}

/// Energy and rows, cell by cell of some axis.
struct Cells {
  std::vector<double> energy;
  std::vector<int> rows;

  explicit Cells(std::size_t count) : energy(count, 0.0), rows(count, 0) {}
  void add(std::size_t cell, double e) { energy[cell] += e, ++rows[cell]; }

  /// Runs of cells that hold more per row than the whole does, [first, last]; a single cell
  /// between two of them counts along.
  std::vector<std::pair<std::size_t, std::size_t>> dense() const {
    const double mean = std::accumulate(energy.begin(), energy.end(), 0.0) /
                        std::max(1, std::accumulate(rows.begin(), rows.end(), 0));
    std::vector<std::pair<std::size_t, std::size_t>> out;
    for (std::size_t c = 0; c < energy.size(); ++c) {
      if (rows[c] == 0 || energy[c] <= mean * rows[c]) continue;
      if (!out.empty() && c - out.back().second <= 2)
        out.back().second = c;
      else
        out.emplace_back(c, c);
    }
    return out;
  }
};

/// The parts of a channel's range, in cells of equal width, in which the energy is dense.
std::vector<Region> regions(const Experiment& e, const Eigen::VectorXd& energy,
                            const std::string& channel) {
  const auto* values = channel_of(e.motion, channel);
  if (!values) return {};
  const Eigen::Map<const Eigen::VectorXd> x(values->data(), Eigen::Index(values->size()));
  Eigen::VectorXd at_rows(e.rows());
  if (e.loadcell_rows() > 0) at_rows.head(e.loadcell_rows()) = e.at_loadcell(x);
  if (e.drive_rows() > 0) at_rows.tail(e.drive_rows()) = e.at_drive(x);
  constexpr int count = 40;
  const double low = x.minCoeff(), width = (x.maxCoeff() - low) / count;
  if (!(width > 0)) return {};
  Cells cells(count);
  for (Eigen::Index i = 0; i < e.rows(); ++i)
    if (e.usable[std::size_t(i)])
      cells.add(std::size_t(std::clamp(int((at_rows[i] - low) / width), 0, count - 1)), energy[i]);
  std::vector<Region> out;
  for (const auto& [first, last] : cells.dense())
    out.push_back({channel, low + width * double(first), low + width * double(last + 1)});
  return out;
}

/// The seconds in which the energy is dense.
std::vector<std::pair<double, double>> intervals(const Experiment& e,
                                                 const Eigen::VectorXd& energy) {
  const double end = e.motion.t.back();
  Cells seconds(std::size_t(std::ceil(end)) + 1);
  for (Eigen::Index i = 0; i < e.rows(); ++i)
    if (e.usable[std::size_t(i)])
      seconds.add(std::size_t(std::clamp(e.time(i), 0.0, end)), energy[i]);
  std::vector<std::pair<double, double>> out;
  for (const auto& [first, last] : seconds.dense())
    out.emplace_back(e.start_s + double(first), e.start_s + std::min(double(last + 1), end));
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
  const Projection projections[2] = {{fits[0].free_columns, fits[0].free_right},
                                     {fits[1].free_columns, fits[1].free_right}};
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
