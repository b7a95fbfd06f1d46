#include "estimator/diagnosis/fit/regression.h"

#include <algorithm>

#include "estimator/diagnosis/fit/normal_equations.h"

namespace searig::estimator {

Solution solve(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right) {
  const Eigen::VectorXd scale = inverse_norms(columns);
  const Eigen::MatrixXd scaled = columns * scale.asDiagonal();
  const auto normal = factors(product(scaled));
  Eigen::VectorXd x = normal.solve(scaled.transpose() * right);
  x += normal.solve(scaled.transpose() * (right - scaled * x));  // gives back the digits
  Solution out;
  out.coefficients = scale.cwiseProduct(x);
  out.residual = right - columns * out.coefficients;
  out.sse = out.residual.squaredNorm();
  out.sd = scale.cwiseProduct(deviations(normal));
  return out;
}

Projection::Projection(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right) {
  const Eigen::VectorXd scale = inverse_norms(columns);
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns * scale.asDiagonal());
  basis_ = qr.householderQ() * Eigen::MatrixXd::Identity(columns.rows(), qr.rank());
  residual_ = right - basis_ * (basis_.transpose() * right);
}

Projection::Gain Projection::gain(const Eigen::MatrixXd& candidate) const {
  Gain out;
  out.coefficients = Eigen::VectorXd::Zero(candidate.cols());
  const double norm = candidate.norm();
  if (!(norm > 0)) return out;
  const Eigen::MatrixXd free = free_part(candidate);
  out.independence = free.norm() / norm;
  if (out.independence < 1e-5) return out;
  const Eigen::VectorXd scale = inverse_norms(free);
  const Eigen::MatrixXd scaled = free * scale.asDiagonal();
  Eigen::MatrixXd normal = scaled.transpose() * scaled;
  normal.diagonal().array() += 1e-9;
  const Eigen::VectorXd right = scaled.transpose() * residual_;
  const Eigen::VectorXd x = normal.ldlt().solve(right);
  out.sse = right.dot(x);
  out.coefficients = scale.cwiseProduct(x);
  return out;
}

double heldout_sse(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right,
                   const std::vector<int>& block, std::vector<double>* each) {
  const int blocks = *std::ranges::max_element(block) + 1;
  const Eigen::Index n = columns.cols();
  const Eigen::VectorXd scale = inverse_norms(columns);
  std::vector<Eigen::MatrixXd> normal(std::size_t(blocks + 1), Eigen::MatrixXd::Zero(n, n));
  std::vector<Eigen::VectorXd> moment(std::size_t(blocks + 1), Eigen::VectorXd::Zero(n));
  std::vector<double> square(std::size_t(blocks + 1), 0.0);
  for (Eigen::Index from = 0; from < columns.rows();) {  // runs of one block
    Eigen::Index to = from;
    while (to < columns.rows() && block[std::size_t(to)] == block[std::size_t(from)]) ++to;
    const auto b = std::size_t(block[std::size_t(from)] + 1);
    const Eigen::MatrixXd rows = columns.middleRows(from, to - from) * scale.asDiagonal();
    const auto y = right.segment(from, to - from);
    normal[b] += rows.transpose() * rows;
    moment[b] += rows.transpose() * y;
    square[b] += y.squaredNorm();
    from = to;
  }
  Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd all_moment = Eigen::VectorXd::Zero(n);
  for (std::size_t b = 0; b < normal.size(); ++b) all += normal[b], all_moment += moment[b];
  double total = 0.0;
  if (each) each->assign(std::size_t(blocks), 0.0);
  for (std::size_t b = 1; b < normal.size(); ++b) {
    Eigen::MatrixXd seen = all - normal[b];
    seen.diagonal().array() += 1e-9;
    const Eigen::VectorXd x = seen.ldlt().solve(all_moment - moment[b]);
    const double sse = square[b] - 2.0 * x.dot(moment[b]) + x.dot(normal[b] * x);
    if (each) (*each)[b - 1] = sse;
    total += sse;
  }
  return total;
}

}  // namespace searig::estimator
