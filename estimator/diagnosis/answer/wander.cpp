#include "estimator/diagnosis/answer/remainder.h"

#include <algorithm>
#include <cmath>

#include "estimator/diagnosis/answer/locate.h"
#include "estimator/diagnosis/fit/regression.h"
#include "estimator/physics/single_amplitude.h"

namespace searig::estimator {
namespace {

constexpr double unlikely = 0.001;

/// The usable part of the load cell's residual.
struct Residual {
  std::vector<double> t, x;

  double power() const { return mean_square(x); }

  /// Mean square of the means over blocks of so many seconds.
  double slow_power(double seconds) const { return mean_square(means(seconds)); }

  std::vector<double> means(double seconds) const {
    std::vector<double> out;
    for (std::size_t from = 0, to; from < x.size(); from = to) {
      double sum = 0.0;
      for (to = from; to < x.size() && same_block(from, to, seconds); ++to) sum += x[to];
      // A last block that is cut short says less than the others, and is left out.
      if (to < x.size() || t[to - 1] - t[from] > 0.45 * seconds)
        out.push_back(sum / double(to - from));
    }
    return out;
  }

  /// Slower than ten seconds for the most part, and not only for a moment.
  bool is_slow() const {
    const double slow = slow_power(8.0);
    return x.size() >= 200 && slow >= 0.3 * power() && slow >= 0.5 * slow_power(2.0);
  }

 private:
  bool same_block(std::size_t a, std::size_t b, double seconds) const {
    return std::floor(t[a] / seconds) == std::floor(t[b] / seconds);
  }
  static double mean_square(const std::vector<double>& values) {
    double sum = 0.0;
    for (const double v : values) sum += v * v;
    return values.empty() ? 0.0 : sum / double(values.size());
  }
};

/// Takes the best single step, and the straight line beside it, out of the residual; returns when.
double take_step_out(Residual& r) {
  const auto n = Eigen::Index(r.x.size());
  Eigen::MatrixXd columns = Eigen::MatrixXd::Ones(n, 2);
  columns.col(1) = as_array(r.t).matrix();
  const Projection line(columns, as_array(r.x).matrix());
  const auto step_from = [&](Eigen::Index row) {
    Eigen::VectorXd out = Eigen::VectorXd::Zero(n);
    out.tail(n - row).setOnes();
    return out;
  };
  const Eigen::Index every = std::max<Eigen::Index>(1, n / 500);
  Eigen::Index at = 1;
  double most = -1.0;
  for (Eigen::Index row = 1; row < n; row += every)
    if (const double gain = line.gain(step_from(row)).sse; gain > most) most = gain, at = row;
  columns.conservativeResize(n, 3);
  columns.col(2) = step_from(at);
  const Eigen::VectorXd left = solve(columns, as_array(r.x).matrix()).residual;
  r.x.assign(left.begin(), left.end());
  return r.t[std::size_t(at)];
}

}  // namespace

std::optional<Unexplained> wanders(const Bench& bench, const Hypothesis& hypothesis) {
  const Experiment& e = bench.experiment();
  const Eigen::VectorXd raw = bench.raw_residual(hypothesis);
  Residual residual;
  for (Eigen::Index i = 0; i < e.loadcell_rows(); ++i)
    if (e.usable[std::size_t(i)]) residual.t.push_back(e.time(i)), residual.x.push_back(raw[i]);
  if (!residual.is_slow()) return std::nullopt;
  Unexplained out;
  out.located.residuals = residuals_of(Path::rig);
  out.located.intervals_s = {{e.start_s, e.start_s + e.motion.t.back()}};
  out.located.share = residual.slow_power(8.0) / residual.power();
  // Chernoff's bound for a mean of squares, were as much of the power that slow anyway as the
  // noise's own memory makes it.
  const double rows_in_block = 8.0 * double(residual.x.size()) / e.motion.t.back();
  const double usual = slow_share(bench.whitening().loadcell(), Eigen::Index(rows_in_block));
  const double x = out.located.share / usual, m = double(residual.means(8.0).size());
  out.p_value = x > 1.0 ? std::exp(-0.5 * m * (x - 1.0 - std::log(x))) : 1.0;
  if (out.p_value > unlikely) return std::nullopt;
  out.what = zero_wanders;
  const double step_s = e.start_s + take_step_out(residual);
  if (!residual.is_slow()) {
    out.what = zero_jumps;
    out.located.intervals_s = {{step_s - 0.5, step_s + 0.5}};
  }
  return out;
}

}  // namespace searig::estimator
