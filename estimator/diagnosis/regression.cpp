#include "estimator/diagnosis/regression.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

namespace searig::estimator {
namespace {

Eigen::VectorXd inverse_norms(const Eigen::MatrixXd& columns) {
  Eigen::VectorXd out = columns.colwise().norm();
  for (double& n : out) n = n > 0 ? 1.0 / n : 0.0;
  return out;
}

/// Cholesky factors of the scaled normal equations; a trace of ridge carries columns that others
/// span, and columns of zeros get a one on the diagonal.
Eigen::LDLT<Eigen::MatrixXd> factors(Eigen::MatrixXd normal) {
  for (double& d : normal.diagonal()) d = d > 0 ? d + 1e-11 : 1.0;
  return Eigen::LDLT<Eigen::MatrixXd>(normal);
}

Eigen::MatrixXd product(const Eigen::MatrixXd& columns) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(columns.cols(), columns.cols());
  out.selfadjointView<Eigen::Lower>().rankUpdate(columns.transpose());
  return out.selfadjointView<Eigen::Lower>();
}

Eigen::VectorXd deviations(const Eigen::LDLT<Eigen::MatrixXd>& normal) {
  const Eigen::MatrixXd inverse =
      normal.solve(Eigen::MatrixXd::Identity(normal.rows(), normal.rows()));
  return inverse.diagonal().cwiseMax(0.0).cwiseSqrt();
}

}  // namespace

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

namespace {

/// Normal equations of some rows.
struct Share {
  Eigen::MatrixXd normal;
  Eigen::VectorXd moment;
  double square;

  Share(const Eigen::MatrixXd& columns, const Eigen::VectorXd& right)
      : normal(product(columns)),
        moment(columns.transpose() * right),
        square(right.squaredNorm()) {}

  /// Sum of squares at x + along*direction, as a polynomial in `along`.
  Eigen::Vector3d squares(const Eigen::VectorXd& x, const Eigen::VectorXd& direction) const {
    const Eigen::VectorXd slope = moment - normal * x;
    return {square - x.dot(moment) - x.dot(slope), -2.0 * direction.dot(slope),
            direction.dot(normal * direction)};
  }
};

double at(const Eigen::Vector3d& polynomial, double x) {
  return polynomial[0] + x * (polynomial[1] + x * polynomial[2]);
}

/// Where a function with one minimum has it, by golden sections.
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

Solution solve(Eigen::MatrixXd& columns, Eigen::VectorXd& right, const FreeScale& s) {
  const Eigen::VectorXd scale = inverse_norms(columns);
  const Eigen::MatrixXd scaled = columns * scale.asDiagonal();
  const Share own(scaled.middleRows(s.first_row, s.rows), right.segment(s.first_row, s.rows));
  Share rest(scaled, right);
  rest.normal -= own.normal, rest.moment -= own.moment, rest.square -= own.square;
  const auto unit = Eigen::VectorXd::Unit(scaled.cols(), s.column);
  constexpr double furthest = 4.6;  // a hundredfold, as a logarithm
  double weight = 1.0;              // (reference/g)^2
  Eigen::VectorXd x;
  Eigen::LDLT<Eigen::MatrixXd> normal;
  for (int round = 0; round < 20; ++round) {
    normal = factors(rest.normal + weight * own.normal);
    x = normal.solve(rest.moment + weight * own.moment);
    const double shrunk = x[s.column] * scale[s.column];
    if (shrunk <= 0.0) break;
    // At the minimum the gradient is that of 1/g^2 alone, so it lies from here in this direction.
    const Eigen::VectorXd direction = normal.solve(unit);
    const auto others = rest.squares(x, direction), those = own.squares(x, direction);
    const auto along = [&](double log_growth) {
      return x[s.column] * std::expm1(log_growth) / direction[s.column];
    };
    const auto relative = [&](double log_growth) {
      return std::pow(s.reference / (shrunk * std::exp(log_growth)), 2);
    };
    const double best = least(
        [&](double growth) {
          return at(others, along(growth)) + relative(growth) * at(those, along(growth));
        },
        0.0, furthest);
    x += along(best) * direction;
    const double before = std::exchange(weight, relative(best));
    if (std::abs(weight - before) < 1e-7 * weight) break;
  }
  Solution out;
  out.coefficients = scale.cwiseProduct(x);
  out.sd = scale.cwiseProduct(deviations(normal));
  const double g = out.coefficients[s.column];
  auto those = columns.middleRows(s.first_row, s.rows);
  those *= std::sqrt(weight), right.segment(s.first_row, s.rows) *= std::sqrt(weight);
  out.residual = right - columns * out.coefficients;
  if (g > 0.0) {
    const Eigen::VectorXd left = out.residual.segment(s.first_row, s.rows);
    those.col(s.column) += left / g;
    right.segment(s.first_row, s.rows) += left;
  }
  out.sse = out.residual.squaredNorm();
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
