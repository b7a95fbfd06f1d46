// The linear error with an honest interval, for a spring that stands still: recursive least
// squares.
#pragma once

#include <cmath>
#include <limits>

#include "estimator/filter/linear_filters.h"
#include "estimator/filter/scaled_states.h"
#include "estimator/filter/score_blocks.h"

namespace searig::estimator {

/// Weighted with the trust (3). It needs no R and no prior: it starts from a P so large that the
/// start is forgotten with the first data.
template <int n>
class LeastSquaresEstimator final : public StateEstimator {
 public:
  LeastSquaresEstimator(const SpringStates& states, const StateOptions& options)
      : initial_k_(options.initial_k_nm_per_rad), k_(states.stiffness()) {
    filter_.x.setZero();
    filter_.P = diffuse * Matrix::Identity();
  }

  void step(const StateSample& sample) override {
    const bool had_units = scale_.started();
    const auto s = scale_.take(sample);
    if (!s) return;
    if (!had_units) filter_.x[k_] = initial_k_ / scale_.unit()[k_];
    if (s->weight > 0) filter_.update(s->phi, s->T, s->weight);
    blocks_.add(s->sums());
  }

  void state(std::span<double> x) const override {
    for (int i = 0; i < n; ++i) x[i] = scale_.started() ? filter_.x[i] * scale_.unit()[i] : 0;
    if (!scale_.started()) x[k_] = initial_k_;
  }

  std::optional<StateCovariance> covariance() const override {
    const Matrix& P = filter_.P;
    StateCovariance out{Eigen::MatrixXd(n, n), Eigen::VectorXd(n)};
    Vector scale;
    for (int i = 0; i < n; ++i) {
      LongRunVariance noise;
      const Vector v = P.col(i) / P(i, i);
      for (const auto& block : blocks_.closed()) noise.add(block, v, filter_.x, P);
      if (!noise.is_known()) return std::nullopt;
      out.dof[i] = noise.dof();
      scale[i] = scale_.unit()[i] * std::sqrt(noise.value());
    }
    out.covariance = scale.asDiagonal() * P * scale.asDiagonal();
    return out;
  }

 private:
  using Vector = Eigen::Vector<double, n>;
  using Matrix = Eigen::Matrix<double, n, n>;

  static constexpr double diffuse = 1e6;

  double initial_k_;
  int k_;
  ScaledStates<n> scale_;
  RecursiveLeastSquares<n> filter_;
  ScoreBlocks<n> blocks_{std::numeric_limits<double>::infinity()};
};

}  // namespace searig::estimator
