#include "estimator/diagnosis/regression.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace searig::estimator {
namespace {

Eigen::VectorXd inverse_norms(const Eigen::MatrixXd& columns) {
  Eigen::VectorXd out = columns.colwise().norm();
  for (double& n : out) n = n > 0 ? 1.0 / n : 0.0;
  return out;
}

/// Cholesky factors of the scaled normal equations; a trace of ridge carries columns that others
/// span, and columns of zeros get a one on the diagonal.
Eigen::LDLT<Eigen::MatrixXd> factors(const Eigen::MatrixXd& scaled) {
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(scaled.cols(), scaled.cols());
  normal.selfadjointView<Eigen::Lower>().rankUpdate(scaled.transpose());
  for (double& d : normal.diagonal()) d = d > 0 ? d + 1e-11 : 1.0;
  return Eigen::LDLT<Eigen::MatrixXd>(normal.selfadjointView<Eigen::Lower>());
}

}  // namespace

namespace {

struct Normal {
  Solution solution;
  Eigen::MatrixXd inverse;  // of the scaled normal equations
  Eigen::VectorXd scale;
};

Normal solve_normal(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right) {
  Normal out;
  out.scale = inverse_norms(columns);
  const Eigen::MatrixXd scaled = columns * out.scale.asDiagonal();
  const auto normal = factors(scaled);
  Eigen::VectorXd x = normal.solve(scaled.transpose() * right);
  x += normal.solve(scaled.transpose() * (right - scaled * x));  // gives back the digits
  out.solution.coefficients = out.scale.cwiseProduct(x);
  out.solution.residual = right - columns * out.solution.coefficients;
  out.solution.sse = out.solution.residual.squaredNorm();
  out.inverse = normal.solve(Eigen::MatrixXd::Identity(columns.cols(), columns.cols()));
  out.solution.sd = out.scale.cwiseProduct(out.inverse.diagonal().cwiseMax(0.0).cwiseSqrt());
  return out;
}

/// The minimum of a function with one, by golden sections.
template <class F>
double least(const F& f, double low, double high) {
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double fa = f(a), fb = f(b);
  while (high - low > 1e-9) {
    if (fa < fb) {
      high = b, b = a, fb = fa, a = high - golden * (high - low), fa = f(a);
    } else {
      low = a, a = b, fa = fb, b = low + golden * (high - low), fb = f(b);
    }
  }
  return 0.5 * (low + high);
}

}  // namespace

Solution solve(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right) {
  return solve_normal(columns, right).solution;
}

Solution solve(Eigen::MatrixXd& columns, Eigen::VectorXd& right, const FreeScale& s) {
  Normal normal = solve_normal(columns, right);
  Solution& out = normal.solution;
  const double shrunk = out.coefficients[s.column];
  // Setting the gradient to zero moves the solution along the inverse's column of g.
  const Eigen::VectorXd direction =
      normal.scale.cwiseProduct(normal.inverse.col(s.column)) * normal.scale[s.column];
  if (shrunk <= 0.0 || direction[s.column] <= 0.0) return out;
  const Eigen::VectorXd change = columns * direction;
  const auto own = [&](const Eigen::VectorXd& x) { return x.segment(s.first_row, s.rows); };
  const auto dot = [&](const Eigen::VectorXd& a, const Eigen::VectorXd& b) {
    return std::pair{a.dot(b) - own(a).dot(own(b)), own(a).dot(own(b))};
  };
  const auto [o0, d0] = dot(out.residual, out.residual);
  const auto [o1, d1] = dot(out.residual, change);
  const auto [o2, d2] = dot(change, change);
  const auto along = [&](double log_growth) {  // how far for g to grow by so much
    return shrunk * std::expm1(log_growth) / direction[s.column];
  };
  const auto cost = [&](double log_growth) {
    const double x = along(log_growth), relative = s.reference / (shrunk * std::exp(log_growth));
    return o0 - 2.0 * x * o1 + x * x * o2 + relative * relative * (d0 - 2.0 * x * d1 + x * x * d2);
  };
  constexpr double furthest = 4.6;  // a hundredfold
  const double x = along(least(cost, 0.0, furthest));
  out.coefficients += x * direction;
  out.residual -= x * change;
  out.sse = out.residual.squaredNorm();
  const Eigen::VectorXd left = own(out.residual);
  columns.col(s.column).segment(s.first_row, s.rows) += left / out.coefficients[s.column];
  right.segment(s.first_row, s.rows) += left;
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
