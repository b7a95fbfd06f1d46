// The filters that are measured, each as one predict and update per step() of the same stream.
#pragma once

#include <Eigen/Core>

#include "estimator/filter/exact_moments.h"
#include "estimator/filter/linear_filters.h"
#include "estimator/filter/ssukf.h"
#include "tests/bench/straight_line.h"

namespace searig::bench {

template <int n>
using Vec = Eigen::Vector<double, n>;
template <int n>
using Mat = Eigen::Matrix<double, n, n>;

constexpr double start[] = {50, 10, 1};

template <int n>
Mat<n> process_noise(const Vec<n>& x) {
  Mat<n> Q = Mat<n>::Zero();
  for (int i = 0; i < n; ++i) Q(i, i) = alpha * std::abs(x[i]);  // (10)
  return Q;
}

template <int n>
Vec<n> regressors(const Sample& s) {
  return Vec<n>(s.phi);
}

/// The product's filter.
template <int n>
struct Ours {
  estimator::Ssukf<n> filter{Vec<n>(start), Mat<n>(100 * Mat<n>::Identity())};

  bool step(const Sample& s) {
    const Vec<n> phi = regressors<n>(s);
    const auto error = [&](const Vec<n>& x) {
      const double e = s.T - phi.dot(x);
      return s.w * e * e;
    };
    return filter.predict(process_noise<n>(filter.state())) && filter.update(error, 0.0, beta);
  }
};

/// The product's closed form of the same moments.
template <int n>
struct Moments {
  estimator::ExactMomentFilter<n> filter{Vec<n>(start), 100 * Mat<n>::Identity()};
  void step(const Sample& s) {
    filter.step(regressors<n>(s), s.T, s.w, process_noise<n>(filter.x), beta);
  }
};

/// An extended Kalman filter on the squared error (8), linearised where it stands:
/// H = -2 w r phi'.
template <int n>
struct Extended {
  Vec<n> x{start};
  Mat<n> P = 100 * Mat<n>::Identity();
  void step(const Sample& s) {
    P += process_noise<n>(x);
    const Vec<n> phi = regressors<n>(s);
    const double r = s.T - phi.dot(x);
    const Vec<n> H = -2 * s.w * r * phi, PH = P * H;
    const Vec<n> K = PH / (H.dot(PH) + beta);
    x -= K * (s.w * r * r);
    P -= K * PH.transpose();
  }
};

/// The product's Kalman filter on the linear error.
template <int n>
struct Linear {
  estimator::LinearKalman<n> filter{Vec<n>(start), 100 * Mat<n>::Identity()};
  void step(const Sample& s) {
    filter.predict(process_noise<n>(filter.x));
    filter.update(regressors<n>(s), s.T, beta / s.w);
  }
};

/// The product's recursive least squares.
template <int n>
struct LeastSquares {
  estimator::RecursiveLeastSquares<n> filter{Vec<n>(start), 100 * Mat<n>::Identity()};
  void step(const Sample& s) { filter.update(regressors<n>(s), s.T, s.w); }
};

}  // namespace searig::bench
