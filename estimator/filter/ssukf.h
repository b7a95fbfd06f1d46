// The spherical simplex unscented Kalman filter, for any small number of states.
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <cmath>
#include <stdexcept>

#include "estimator/filter/sigma_points.h"
#include "estimator/filter/small_cholesky.h"

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
    if (!take_over(x, symmetric(P))) {
      throw std::invalid_argument("the filter needs a finite state and a positive covariance");
    }
  }

  const State& state() const { return x_; }
  const Covariance& covariance() const { return P_; }

  /// Puts the state elsewhere and keeps its covariance.
  void set_state(const State& x) { x_ = x; }

  /// Process model x_t = x_{t-1} (7): P = P + Q. False, and nothing has happened, where the result
  /// is not a covariance.
  [[nodiscard]] bool predict(const Covariance& Q) {
    Covariance P, L = Covariance::Zero();
    unrolled<n>([&]<int j>() { unrolled<n>([&]<int k>() { P(j, k) = P_(j, k) + Q(j, k); }); });
    if (!small_cholesky<n>(P, L)) return false;
    return take_over(x_, P, L);
  }

  /// Process model x_t = f(x_{t-1}) (5).
  ///   X_i = f(x + L Z_i),  x = sum Wm_i X_i,  P = sum Wc_i (X_i - x)(X_i - x)' + Q
  template <class F>
  [[nodiscard]] bool predict(F&& f, const Covariance& Q) {
    if (!drawable()) return false;
    Spread<n> X = draw();
    for (int i = 0; i < Points::count; ++i) X.col(i) = f(State(X.col(i)));
    const State mean = X * points_.mean_weights();
    X.colwise() -= mean;
    const auto W = points_.covariance_weights().asDiagonal();
    return take_over(mean, symmetric(X * W * X.transpose() + Q));
  }

  /// Observes z = h(x) (6) with noise R. h takes a State and returns a fixed-size vector.
  ///   Y_i = h(X_i),  y = sum Wm_i Y_i
  ///   Pyy = sum Wc_i (Y_i - y)(Y_i - y)' + R,  Pxy = sum Wc_i (X_i - x)(Y_i - y)'
  ///   K = Pxy Pyy^-1,  x = x + K (z - y),  P = P - K Pyy K'
  /// False, and nothing has happened, where the result is not finite or P not positive.
  template <class H, int m>
  [[nodiscard]] bool update(H&& h, const Eigen::Vector<double, m>& z,
                            const Eigen::Matrix<double, m, m>& R) {
    if (!drawable()) return false;
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
    return take_over(x_ + K * (z - y), symmetric(P_ - K * Pxy.transpose()));
  }

  /// The same for one number: h takes a State and returns a double. What the paper needs, written
  /// out, as it is the whole cost of the estimator. With u = sum Wc_i Z_i (Y_i - y) is Pxy = L u,
  /// and P - Pxy Pxy'/Pyy = L (I - u u'/Pyy) L' is positive where u'u < Pyy: no second factor.
  template <class H>
  [[nodiscard]] bool update(H&& h, double z, double R) {
    if (!drawable()) return false;
    const auto& Z = points_.points();
    const auto &Wm = points_.mean_weights(), &Wc = points_.covariance_weights();
    Eigen::Vector<double, Points::count> Y;
    double y = 0;
    unrolled<Points::count>([&]<int i>() {
      Y[i] = h(point<i>());
      y += Wm[i] * Y[i];
    });
    State u = State::Zero();
    double Pyy = R;
    unrolled<Points::count>([&]<int i>() {
      const double error = Y[i] - y, weighted = Wc[i] * error;
      Pyy += weighted * error;
      unrolled<n>([&]<int j>() {
        if constexpr (!Points::is_zero(j, i)) u[j] += Z(j, i) * weighted;
      });
    });
    return correct(u, Pyy, z - y);
  }

 private:
  template <int rows>
  using Spread = Eigen::Matrix<double, rows, Points::count>;

  static constexpr double least_left = 1e-12;  // of the variance, after one measurement

  // X_i = x + L Z_i
  template <int i>
  State point() const {
    State X = x_;
    unrolled<n>([&]<int j>() {
      if constexpr (!Points::is_zero(j, i)) {
        unrolled<n - j>([&]<int k>() { X[j + k] += L_(j + k, j) * points_.points()(j, i); });
      }
    });
    return X;
  }

  Spread<n> draw() const {
    Spread<n> X;
    unrolled<Points::count>([&]<int i>() { X.col(i) = point<i>(); });
    return X;
  }

  // x = x + K (z - y), P = P - K Pxy' with K = Pxy/Pyy
  bool correct(const State& u, double Pyy, double innovation) {
    State Pxy = State::Zero(), x = x_;
    double u2 = 0, sum = 0;
    unrolled<n>([&]<int j>() {
      u2 += u[j] * u[j];
      unrolled<n - j>([&]<int k>() { Pxy[j + k] += L_(j + k, j) * u[j]; });
    });
    const double per_Pyy = 1 / Pyy;
    unrolled<n>([&]<int j>() {
      x[j] += Pxy[j] * per_Pyy * innovation;
      sum += x[j];
    });
    if (!(u2 < Pyy * (1 - least_left)) || !std::isfinite(sum)) return false;
    x_ = x;
    unrolled<n>([&]<int j>() {
      const double K = Pxy[j] * per_Pyy;
      unrolled<n>([&]<int k>() { P_(j, k) -= K * Pxy[k]; });
    });
    factored_ = false;
    return true;
  }

  bool drawable() { return factored_ || (factored_ = small_cholesky<n>(P_, L_)); }

  static Covariance symmetric(const Covariance& P) { return (P + P.transpose()) / 2; }

  // Takes x and P over if they make sense: the filter is never left in a state it cannot draw from.
  bool take_over(const State& x, const Covariance& P) {
    Covariance L = Covariance::Zero();
    return x.allFinite() && small_cholesky<n>(P, L) && take_over(x, P, L);
  }

  bool take_over(const State& x, const Covariance& P, const Covariance& L) {
    // Number by number, as they are read again: a processor waits where two numbers were written
    // apart and are read together.
    unrolled<n>([&]<int j>() {
      x_[j] = x[j];
      unrolled<n>([&]<int k>() { P_(j, k) = P(j, k); });
      unrolled<j + 1>([&]<int k>() { L_(j, k) = L(j, k); });
    });
    return factored_ = true;
  }

  Points points_;
  State x_;
  Covariance P_;
  Covariance L_;           // P = L L'; only its lower triangle is ever used
  bool factored_ = false;  // whether L belongs to P
};

}  // namespace searig::estimator
