#include "estimator/diagnosis/fit/free_scale.h"

#include <cmath>
#include <utility>

#include "estimator/diagnosis/fit/normal_equations.h"

namespace searig::estimator {
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

/// A solution on the way, with the weight (reference/g)^2 that it was found at.
struct Iterate {
  double weight = 1.0;
  Eigen::VectorXd x;
  Eigen::LDLT<Eigen::MatrixXd> normal;
};

/// Solves at the iterate's weight, then goes on to where the minimum is if the gradient is that of
/// 1/g^2 alone: along one line. False where that changes nothing any more, or g is not positive.
bool improve(Iterate& it, const Share& rest, const Share& own, const FreeScale& s, double scale) {
  it.normal = factors(rest.normal + it.weight * own.normal);
  it.x = it.normal.solve(rest.moment + it.weight * own.moment);
  const double shrunk = it.x[s.column] * scale;
  if (shrunk <= 0.0) return false;
  const Eigen::VectorXd direction = it.normal.solve(Eigen::VectorXd::Unit(it.x.size(), s.column));
  const auto others = rest.squares(it.x, direction), those = own.squares(it.x, direction);
  const auto along = [&](double log_growth) {
    return it.x[s.column] * std::expm1(log_growth) / direction[s.column];
  };
  const auto relative = [&](double log_growth) {
    return std::pow(s.reference / (shrunk * std::exp(log_growth)), 2);
  };
  constexpr double furthest = 4.6;  // a hundredfold, as a logarithm
  const double best = least(
      [&](double growth) {
        return at(others, along(growth)) + relative(growth) * at(those, along(growth));
      },
      0.0, furthest);
  it.x += along(best) * direction;
  const double before = std::exchange(it.weight, relative(best));
  return !(std::abs(it.weight - before) < 1e-7 * it.weight);
}

/// Columns and right side as an ordinary least-squares problem about the solution.
void linearise(Eigen::MatrixXd& columns, Eigen::VectorXd& right, const FreeScale& s, double weight,
               Solution& solution) {
  auto those = columns.middleRows(s.first_row, s.rows);
  those *= std::sqrt(weight), right.segment(s.first_row, s.rows) *= std::sqrt(weight);
  solution.residual = right - columns * solution.coefficients;
  const double g = solution.coefficients[s.column];
  if (g <= 0.0) return;
  const Eigen::VectorXd left = solution.residual.segment(s.first_row, s.rows);
  those.col(s.column) += left / g;
  right.segment(s.first_row, s.rows) += left;
}

}  // namespace

Solution solve(Eigen::MatrixXd& columns, Eigen::VectorXd& right, const FreeScale& s) {
  const Eigen::VectorXd scale = inverse_norms(columns);
  const Eigen::MatrixXd scaled = columns * scale.asDiagonal();
  const Share own(scaled.middleRows(s.first_row, s.rows), right.segment(s.first_row, s.rows));
  Share rest(scaled, right);
  rest.normal -= own.normal, rest.moment -= own.moment, rest.square -= own.square;
  Iterate it;
  for (int round = 0; round < 20 && improve(it, rest, own, s, scale[s.column]);) ++round;
  Solution out;
  out.coefficients = scale.cwiseProduct(it.x);
  out.sd = scale.cwiseProduct(deviations(it.normal));
  linearise(columns, right, s, it.weight, out);
  out.sse = out.residual.squaredNorm();
  return out;
}

}  // namespace searig::estimator
