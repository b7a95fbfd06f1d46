// The spherical simplex unscented Kalman filter, for any small number of states.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <stdexcept>
#include <type_traits>

#include "estimator/filter/sigma_points.h"

namespace searig::estimator {

/// An unscented Kalman filter with n states. All sizes are known to the compiler and no call
/// allocates memory. Shapes: x is n, P and Q are n x n, z is m, R is m x m.
///
/// Sigma points live inside one function call only, and are always drawn from the P of that
/// moment. Two well-known libraries keep the points that were drawn before Q was added, for the
/// measurement or for the cross covariance: Q is then missing from the gain. With a small Q
/// nothing is seen of it; with a large one the filter is no longer a Kalman filter.
template <int n, SigmaPointSet<n> Points = SphericalSimplex<n>>
class Ssukf {
 public:
  using State = Eigen::Vector<double, n>;
  using Covariance = Eigen::Matrix<double, n, n>;

  /// Throws std::invalid_argument unless P is finite and positive definite.
  Ssukf(const State& x, const Covariance& P, Points points = Points())
      : points_(std::move(points)) {
    if (!accept(x, P)) {
      throw std::invalid_argument("the filter needs a finite state and a positive covariance");
    }
  }

  const State& state() const { return x_; }
  const Covariance& covariance() const { return P_; }

  /// Puts the state elsewhere and keeps its covariance.
  void set_state(const State& x) { x_ = x; }

  /// Process model x_t = x_{t-1} (7): P = P + Q. False, and nothing has happened, where the result
  /// is not a covariance.
  [[nodiscard]] bool predict(const Covariance& Q) { return accept(x_, P_ + Q); }

  /// Process model x_t = f(x_{t-1}) (5).
  ///   X_i = f(x + L Z_i),  x = sum Wm_i X_i,  P = sum Wc_i (X_i - x)(X_i - x)' + Q
  template <class F>
  [[nodiscard]] bool predict(F&& f, const Covariance& Q) {
    Spread<n> X = draw();
    for (int i = 0; i < Points::count; ++i) X.col(i) = f(State(X.col(i)));
    const State mean = X * points_.mean_weights();
    X.colwise() -= mean;
    return accept(mean, X * points_.covariance_weights().asDiagonal() * X.transpose() + Q);
  }

  /// Observes z = h(x) (6) with noise R. h takes a State and returns a fixed-size vector.
  ///   Y_i = h(X_i),  y = sum Wm_i Y_i
  ///   Pyy = sum Wc_i (Y_i - y)(Y_i - y)' + R,  Pxy = sum Wc_i (X_i - x)(Y_i - y)'
  ///   K = Pxy Pyy^-1,  x = x + K (z - y),  P = P - K Pyy K'
  /// False, and nothing has happened, where the result is not finite or P not positive.
  template <class H, int m>
  [[nodiscard]] bool update(H&& h, const Eigen::Vector<double, m>& z,
                            const Eigen::Matrix<double, m, m>& R) {
    Spread<n> X = draw();
    Spread<m> Y;
    for (int i = 0; i < Points::count; ++i) Y.col(i) = h(State(X.col(i)));
    const Eigen::Vector<double, m> y = Y * points_.mean_weights();
    X.colwise() -= x_;
    Y.colwise() -= y;
    const auto W = points_.covariance_weights().asDiagonal();
    const Eigen::Matrix<double, m, m> Pyy = Y * W * Y.transpose() + R;
    const Eigen::Matrix<double, n, m> Pxy = X * W * Y.transpose();
    const Eigen::Matrix<double, n, m> K = Pyy.llt().solve(Pxy.transpose()).transpose();
    return accept(x_ + K * (z - y), P_ - K * Pxy.transpose());
  }

  /// The same for one number: h takes a State and returns a double.
  template <class H>
  [[nodiscard]] bool update(H&& h, double z, double R) {
    using One = Eigen::Vector<double, 1>;
    return update([&](const State& x) { return One(h(x)); }, One(z), One(R));
  }

 private:
  template <int rows>
  using Spread = Eigen::Matrix<double, rows, Points::count>;

  Spread<n> draw() const { return (L_ * points_.points()).colwise() + x_; }  // X_i = x + L Z_i

  // Takes x and P over if they make sense: the filter is never left in a state it cannot draw from.
  bool accept(const State& x, const Covariance& P) {
    const Covariance symmetric = (P + P.transpose()) / 2;
    const Eigen::LLT<Covariance> cholesky(symmetric);
    if (!x.allFinite() || !symmetric.allFinite() || cholesky.info() != Eigen::Success) return false;
    x_ = x;
    P_ = symmetric;
    L_ = cholesky.matrixL();
    return true;
  }

  Points points_;
  State x_;
  Covariance P_;
  Covariance L_;  // lower triangular, P = L L'
};

}  // namespace searig::estimator
