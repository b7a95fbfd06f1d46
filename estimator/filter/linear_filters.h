// Filters on the torque error itself instead of its square: T = phi'x + v is linear in the
// spring's parameters, so that nothing is approximated and P means what it says.
#pragma once

#include <Eigen/Core>

namespace searig::estimator {

/// Kalman's filter for x from one number T = phi'x + v, Var v = R (R. E. Kalman, J. Basic Eng. 82,
/// 1960). Shapes: x and phi are n, P and Q are n x n.
///   e = T - phi'x,  S = phi'P phi + R,  K = P phi / S,  x = x + K e,  P = P - K S K'
template <int n>
struct LinearKalman {
  Eigen::Vector<double, n> x;
  Eigen::Matrix<double, n, n> P;

  void predict(const Eigen::Matrix<double, n, n>& Q) { P += Q; }

  void update(const Eigen::Vector<double, n>& phi, double T, double R) {
    const double e = T - phi.dot(x);
    const Eigen::Vector<double, n> Pphi = P * phi;
    const Eigen::Vector<double, n> K = Pphi / (phi.dot(Pphi) + R);
    x += K * e;
    P -= K * Pphi.transpose();
  }
};

/// Recursive least squares: what minimises sum_i w_i (T_i - phi_i'x)^2 (L. Ljung, System
/// Identification, 1999, section 11.2). P is the covariance of x for a noise of variance 1.
template <int n>
struct RecursiveLeastSquares {
  Eigen::Vector<double, n> x;
  Eigen::Matrix<double, n, n> P;

  void update(const Eigen::Vector<double, n>& phi, double T, double w) {
    const double e = T - phi.dot(x);
    const Eigen::Vector<double, n> Pphi = P * phi;
    const Eigen::Vector<double, n> K = Pphi * (w / (1 + w * phi.dot(Pphi)));
    x += K * e;
    P -= K * Pphi.transpose();
  }
};

}  // namespace searig::estimator
