// The same filter without sigma points, where the moments are known in closed form.
#pragma once

#include <Eigen/Core>

namespace searig::estimator {

/// Mean, variance and cross covariance of y = w (T - phi'x)^2 for a Gaussian x ~ (x, P).
/// Shapes: phi, x and cross are n, P is n x n.
///
/// With r = T - phi'x and q = phi'P phi, the error r is Gaussian (r, q), so
///   E[y]      = w (r^2 + q)
///   Var[y]    = w^2 (4 r^2 q + 2 q^2)
///   Cov[x, y] = -2 w r P phi
/// The oracle of the tests, and a rival at half the price of the sigma points.
template <int n>
struct SquaredErrorMoments {
  double mean;
  double variance;
  Eigen::Vector<double, n> cross;

  SquaredErrorMoments(const Eigen::Vector<double, n>& x, const Eigen::Matrix<double, n, n>& P,
                      const Eigen::Vector<double, n>& phi, double T, double w) {
    const double r = T - phi.dot(x);
    const double q = phi.dot(P * phi);
    mean = w * (r * r + q);
    variance = w * w * (4 * r * r * q + 2 * q * q);
    cross = -2 * w * r * P * phi;
  }
};

/// One step of the Kalman filter on those moments: observes an error of 0 with noise R.
template <int n>
struct ExactMomentFilter {
  Eigen::Vector<double, n> x;
  Eigen::Matrix<double, n, n> P;

  void step(const Eigen::Vector<double, n>& phi, double T, double w,
            const Eigen::Matrix<double, n, n>& Q, double R) {
    P += Q;
    const SquaredErrorMoments<n> y(x, P, phi, T, w);
    const double Pyy = y.variance + R;
    x -= y.cross / Pyy * y.mean;
    P -= y.cross * y.cross.transpose() / Pyy;
  }
};

}  // namespace searig::estimator
