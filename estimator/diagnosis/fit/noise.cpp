#include "estimator/diagnosis/fit/noise.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "estimator/order.h"

namespace searig::estimator {
namespace {

/// At least this share of the noise is taken to be white. Without it a smooth misfit would pass for
/// noise with a long memory, and any model would fit.
constexpr double white_share = 0.01;

double robust_sd(std::vector<double> x) {
  if (x.empty()) return 1.0;
  for (double& v : x) v = std::abs(v);
  return 1.4826 * median(std::move(x));
}

}  // namespace

double slow_share(const Autoregression& noise, Eigen::Index rows) {
  // With x = sum_j psi_j e_{t-j} the sum over n rows holds e_s times the psi that fall inside.
  const Eigen::Index memory = 10 * rows;
  Eigen::VectorXd psi = Eigen::VectorXd::Zero(rows + memory);
  psi[0] = 1.0;
  for (Eigen::Index j = 1; j < psi.size(); ++j)
    for (Eigen::Index k = 1; k <= std::min(j, noise.phi.size()); ++k)
      psi[j] += noise.phi[k - 1] * psi[j - k];
  double sum = 0.0, within = 0.0;
  for (Eigen::Index j = 0; j < psi.size(); ++j) {
    within += psi[j] - (j >= rows ? psi[j - rows] : 0.0);
    sum += within * within;
  }
  const double n = double(rows);
  return std::min(1.0, sum / (n * n * psi.squaredNorm()));
}

Autoregression fit_autoregression(const Eigen::VectorXd& residual, const std::vector<bool>& usable,
                                  int order) {
  Eigen::VectorXd covariance = Eigen::VectorXd::Zero(order + 1);
  for (int lag = 0; lag <= order; ++lag) {
    double sum = 0.0;
    int n = 0;
    for (Eigen::Index i = lag; i < residual.size(); ++i)
      if (usable[std::size_t(i)] && usable[std::size_t(i - lag)]) {
        sum += residual[i] * residual[i - lag];
        ++n;
      }
    covariance[lag] = n > 0 ? sum / n : 0.0;
  }
  Autoregression out{Eigen::VectorXd::Zero(order), 1.0};
  if (covariance[0] <= 0) return out;
  Eigen::MatrixXd toeplitz(order, order);
  for (int r = 0; r < order; ++r)
    for (int c = 0; c < order; ++c) toeplitz(r, c) = covariance[std::abs(r - c)];
  toeplitz.diagonal() *= 1.0 + white_share;
  out.phi = toeplitz.ldlt().solve(covariance.tail(order));
  std::vector<double> innovation;
  for (Eigen::Index i = order; i < residual.size(); ++i) {
    bool whole = true;
    double e = residual[i];
    for (int k = 0; k <= order; ++k) whole = whole && usable[std::size_t(i - k)];
    for (int k = 1; k <= order; ++k) e -= out.phi[k - 1] * residual[i - k];
    if (whole) innovation.push_back(e);
  }
  double square = 0.0;
  const double limit = 5.0 * robust_sd(innovation);  // outliers must not widen the noise
  std::size_t kept = 0;
  for (const double e : innovation)
    if (std::abs(e) <= limit) square += e * e, ++kept;
  out.sd = kept > 0 && square > 0 ? std::sqrt(square / double(kept)) : std::sqrt(covariance[0]);
  return out;
}

namespace {

Autoregression noise_of(const Experiment& e, const Eigen::VectorXd& residual, Eigen::Index from,
                        Eigen::Index to, bool memory) {
  return fit_autoregression(residual.segment(from, to - from),
                            {e.usable.begin() + from, e.usable.begin() + to},
                            memory ? Whitening::order : 0);
}

}  // namespace

Whitening::Whitening(const Experiment& e, const Eigen::VectorXd& residual, bool memory)
    : Whitening(e, noise_of(e, residual, 0, e.loadcell_rows(), memory),
                noise_of(e, residual, e.loadcell_rows(), e.rows(), memory)) {}

Whitening::Whitening(const Experiment& e, Autoregression loadcell, Autoregression drive)
    : loadcell_(std::move(loadcell)),
      drive_(std::move(drive)),
      split_(e.loadcell_rows()),
      rows_(e.rows()),
      counts_(std::size_t(e.rows()), false),
      weight_(e.weight) {
  const auto mark = [&](Eigen::Index from, Eigen::Index to) {
    if (to - from < 3) return;
    const double step = (e.time(to - 1) - e.time(from)) / double(to - from - 1);
    Eigen::Index run = 0;  // usable rows in a row, without a missing one
    for (Eigen::Index i = from; i < to; ++i) {
      if (i > from && e.time(i) - e.time(i - 1) > 1.5 * step) run = 0;
      run = e.usable[std::size_t(i)] ? run + 1 : 0;
      counts_[std::size_t(i)] = run > order;
    }
  };
  mark(0, split_);
  mark(split_, rows_);
}

Eigen::MatrixXd Whitening::operator()(const Eigen::MatrixXd& columns) const {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(columns.rows(), columns.cols());
  for (Eigen::Index c = 0; c < columns.cols(); ++c) {
    const double* x = columns.col(c).data();
    double* y = out.col(c).data();
    for (Eigen::Index i = order; i < rows_; ++i) {
      if (!counts_[std::size_t(i)]) continue;
      const Autoregression& ar = i < split_ ? loadcell_ : drive_;
      double e = x[i];
      for (Eigen::Index k = 1; k <= ar.phi.size(); ++k) e -= ar.phi[k - 1] * x[i - k];
      y[i] = weight_[std::size_t(i)] * e / ar.sd;
    }
    for (Eigen::Index i = rows_; i < columns.rows(); ++i) y[i] = x[i];  // prior rows are white
  }
  return out;
}

Eigen::Index Whitening::used_rows() const {
  return std::ranges::count(counts_, true);
}

}  // namespace searig::estimator
