// The Cholesky factor of a covariance whose size the compiler knows, without loops at run time.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <utility>

namespace searig::estimator {

/// Calls body<0>(), ..., body<count - 1>(): a loop that is written out, with constants for indices.
template <int count, class Body>
constexpr void unrolled(Body&& body) {
  [&]<int... i>(std::integer_sequence<int, i...>) {
    (body.template operator()<i>(), ...);
  }
  (std::make_integer_sequence<int, count>());
}

/// P = L L', L lower triangular; only the lower triangles of P and L are used. False, and L is of
/// no use, where P is not finite or not positive definite.
/// Eigen's own LLT is written for large matrices: at n = 1 to 3 it costs as much as all the rest of
/// a filter step.
template <int n>
[[nodiscard]] constexpr bool small_cholesky(const Eigen::Matrix<double, n, n>& P,
                                            Eigen::Matrix<double, n, n>& L) {
  bool positive = true;
  unrolled<n>([&]<int j>() {
    double pivot = P(j, j);
    unrolled<j>([&]<int k>() { pivot -= L(j, k) * L(j, k); });
    // A bad number off the diagonal comes to light in the pivots that follow it.
    positive &= pivot > 0 && pivot <= std::numeric_limits<double>::max();
    L(j, j) = std::sqrt(pivot);
    unrolled<n - 1 - j>([&]<int below>() {
      constexpr int i = j + 1 + below;
      double sum = P(i, j);
      unrolled<j>([&]<int k>() { sum -= L(i, k) * L(j, k); });
      L(i, j) = sum / L(j, j);
    });
  });
  return positive;
}

}  // namespace searig::estimator
