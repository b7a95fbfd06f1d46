// Sigma points: a handful of points whose weighted mean and covariance are 0 and I.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <concepts>
#include <stdexcept>
#include <type_traits>

namespace searig::estimator {

/// What a filter of n states asks of a set of sigma points: unit points Z_i (columns) for mean 0
/// and covariance I, weights for the mean and weights for covariances. The filter moves them to
/// its own mean and covariance: X_i = x + L Z_i with P = L L'.
template <class S, int n>
concept SigmaPointSet = requires(const S& set) {
  { S::count } -> std::convertible_to<int>;
  { set.points() } -> std::convertible_to<Eigen::Matrix<double, n, S::count>>;
  { set.mean_weights() } -> std::convertible_to<Eigen::Vector<double, S::count>>;
  { set.covariance_weights() } -> std::convertible_to<Eigen::Vector<double, S::count>>;
  {std::bool_constant<S::is_zero(0, 0)>()};  // whether component (row, point) is always 0
};

/// The three free numbers of a spherical simplex.
struct SimplexOptions {
  double w0 = 0.5;     ///< weight of the centre point, in [0, 1)
  double alpha = 1.0;  ///< spread of the points about the mean; 1 is the unscaled simplex
  double beta = 0.0;   ///< added to the centre's covariance weight; 2 is right for Gaussians
};

/// The numbers with which a *squared* error is observed without bias.
///
/// n = 1: the simplex is symmetric, and w0 = 2/3 gives it the fourth moment of a Gaussian, so that
/// mean, variance and cross covariance of a square are exact, with no cancellation.
/// n >= 2: a simplex is not symmetric. Its third moments are not zero (E[z1^2 z2] = -1 for n = 2
/// and w0 = 1/2), a square turns them into a cross covariance that is not there, and the estimate
/// is pulled aside. They shrink with alpha, and so does the bias: in a run of 131 s with k = 80 and
/// three states it is 1.6 at alpha = 1e-3, 0.23 at 1e-4, 0.04 at 1e-5, 0.02 with exact moments. The
/// price of a small alpha is cancellation: 10 of 16 digits of the predicted error at 1e-5, whose
/// noise is never that small.
template <int n>
constexpr SimplexOptions unbiased_for_squares() {
  if constexpr (n == 1) return {.w0 = 2.0 / 3.0, .alpha = 1.0, .beta = 0.0};
  return {.w0 = 0.0, .alpha = 1e-5, .beta = 2.0};
}

/// Spherical simplex: n + 2 points, all but the centre at the same distance from it
/// (S. J. Julier, "The spherical simplex unscented transformation", ACC 2003). The paper's
/// reference [14]; a plain unscented filter needs 2n + 1.
template <int n>
class SphericalSimplex {
 public:
  static constexpr int count = n + 2;
  using Points = Eigen::Matrix<double, n, count>;
  using Weights = Eigen::Vector<double, count>;

  explicit SphericalSimplex(SimplexOptions options = unbiased_for_squares<n>()) {
    if (!(options.w0 >= 0 && options.w0 < 1 && options.alpha > 0)) {
      throw std::invalid_argument("a spherical simplex needs 0 <= w0 < 1 and alpha > 0");
    }
    place(options);
    weigh(options);
  }

  /// The centre is at 0, and the point that dimension j brings has no part in the later ones.
  static constexpr bool is_zero(int row, int point) { return point == 0 || point > row + 2; }

  const Points& points() const { return points_; }
  const Weights& mean_weights() const { return mean_weights_; }
  const Weights& covariance_weights() const { return covariance_weights_; }

 private:
  // Dimension by dimension, with W1 = (1 - W0)/(n + 1):
  //   n = 1:       Z_1 = -1/sqrt(2 W1),  Z_2 = +1/sqrt(2 W1)
  //   j = 2 .. n:  Z_1 .. Z_j get the component -1/sqrt(j (j+1) W1),
  //                the new Z_{j+1} is (0, ..., 0, j/sqrt(j (j+1) W1)); Z_0 stays 0.
  // The numerator of the new point is j: with 1, as some print it, the mean is not zero.
  void place(const SimplexOptions& options) {
    const double w1 = (1 - options.w0) / (n + 1);
    points_.setZero();
    for (int j = 1; j <= n; ++j) {
      const double unit = options.alpha / std::sqrt(j * (j + 1) * w1);
      points_.row(j - 1).segment(1, j).setConstant(-unit);
      points_(j - 1, j + 1) = j * unit;
    }
  }

  // Scaled weights: W_i/alpha^2 for i >= 1, the centre takes what is left of 1; its covariance
  // weight has 1 - alpha^2 + beta on top (S. J. Julier, "The scaled unscented transformation").
  void weigh(const SimplexOptions& options) {
    const double alpha2 = options.alpha * options.alpha;
    mean_weights_.setConstant((1 - options.w0) / (n + 1) / alpha2);
    mean_weights_(0) = options.w0 / alpha2 + 1 - 1 / alpha2;
    covariance_weights_ = mean_weights_;
    covariance_weights_(0) += 1 - alpha2 + options.beta;
  }

  Points points_;
  Weights mean_weights_;
  Weights covariance_weights_;
};

}  // namespace searig::estimator
