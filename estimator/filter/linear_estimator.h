// The linear error with an honest interval, for a spring that changes: Kalman's filter.
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "estimator/filter/linear_filters.h"
#include "estimator/filter/scaled_states.h"
#include "estimator/filter/score_blocks.h"

namespace searig::estimator {

/// Observes T_current = phi'x + v, Var v = R/w: the error of (8) before it is squared, with the
/// same trust. R is the residual's long-run variance, over blocks of up to two seconds, or
/// half of one where the spring softens: it must not change much within one. As R is known only
/// after a while, the filter is at first run again from its prior over the blocks of the past, with
/// the R of now, whenever a block is full: else the first seconds would count for ever with what
/// was guessed of R then.
///
/// The prior: k as it is given, give or take as much again; any other term may be as large as the
/// whole torque; the loss of spring.mullins is 0 within softening_share of k.
template <int n>
class LinearEstimator final : public StateEstimator {
 public:
  LinearEstimator(const SpringStates& states, const StateOptions& options)
      : options_(options),
        k_(states.stiffness()),
        loss_(states.softening().value_or(-1)),
        blocks_(loss_ >= 0 ? 0.5 : 2.0) {}

  void step(const StateSample& sample) override {
    const auto s = scale_.take(sample);
    if (!s) return;
    if (!started_) start(s->dt_s);
    const ScoreBlock<n> sums = s->sums();
    predict(filter_, sums);
    if (s->weight > 0) {
      const double e = s->T - s->phi.dot(filter_.x);
      white_ += (s->weight * e * e - white_) * std::min(1.0, s->dt_s / white_s);
      filter_.update(s->phi, s->T, R_ / s->weight);
    }
    if (blocks_.add(sums)) learn_noise();
  }

  void state(std::span<double> x) const override {
    for (int i = 0; i < n; ++i) x[i] = started_ ? filter_.x[i] * scale_.unit()[i] : 0;
    if (!started_) x[k_] = options_.initial_k_nm_per_rad;
  }

  std::optional<StateCovariance> covariance() const override {
    StateCovariance out{Eigen::MatrixXd(n, n), Eigen::VectorXd(n)};
    Vector scale;
    const Vector power = powers_of_R();
    for (int i = 0; i < n; ++i) {
      if (!noise_[i].is_known()) return std::nullopt;
      out.dof[i] = noise_[i].dof() / (power[i] * power[i]);
      scale[i] =
          scale_.unit()[i] * std::pow(std::max(noise_[i].value(), white_) / R_, power[i] / 2);
    }
    out.covariance = scale.asDiagonal() * filter_.P * scale.asDiagonal();
    return out;
  }

 private:
  using Vector = Eigen::Vector<double, n>;
  using Matrix = Eigen::Matrix<double, n, n>;

  static constexpr double white_s = 5;
  static constexpr double longest_run_again_s = 1;  // the spring must not change much within one

  void start(double dt_s) {
    // Until it is known: a tenth of the torque, for 50 ms in the same direction.
    R_ = 0.01 * std::max(1.0, 0.05 / dt_s);
    white_ = 0.01;
    filter_ = prior();
    started_ = true;
  }

  LinearKalman<n> prior() const {
    const double k = options_.initial_k_nm_per_rad / scale_.unit()[k_];
    LinearKalman<n> out{Vector::Zero(), Matrix::Identity()};
    out.x[k_] = k;
    out.P(k_, k_) = k * k + 1;
    if (loss_ >= 0) out.P(loss_, loss_) = std::pow(options_.softening_share * k, 2);
    return out;
  }

  // (7), with Q for what may change. (10) knows no time; here Q grows with it, or with the work.
  void predict(LinearKalman<n>& filter, const ScoreBlock<n>& passed) const {
    const double k2 = filter.x[k_] * filter.x[k_];
    Matrix Q = Matrix::Zero();
    if (loss_ >= 0) {
      const Softening softening(options_, passed.resting_s, passed.work);
      filter.x[loss_] *= softening.kept;
      filter.P.row(loss_) *= softening.kept;
      filter.P.col(loss_) *= softening.kept;
      Q(loss_, loss_) = softening.variance * k2;
    } else {
      Q(k_, k_) = options_.drift_per_minute * options_.drift_per_minute / 60 * k2 * passed.seconds;
    }
    filter.predict(Q);
  }

  // A whole block at once: P = (P^-1 + A/R)^-1, x = x + P (g - A x)/R.
  static void update(LinearKalman<n>& filter, const ScoreBlock<n>& block, double R) {
    const Matrix S = Matrix::Identity() + filter.P * block.A / R;
    const Matrix P = S.partialPivLu().solve(filter.P);
    filter.P = (P + P.transpose()) / 2;
    filter.x += filter.P * (block.g - block.A * filter.x) / R;
  }

  void learn_noise() {
    blocks_.last().x = filter_.x;
    blocks_.last().P = filter_.P / R_;
    // Twice: a new R gives new residuals, and those a better R.
    for (int pass = 0; pass < 2; ++pass) {
      if (blocks_.is_whole() && blocks_.length_s() <= longest_run_again_s) run_again();
      const Matrix v = directions();
      LongRunVariances<n> noise;
      for (const ScoreBlock<n>& block : blocks_.closed()) {
        for (int i = 0; i < n; ++i) noise[i].add(block, v.col(i), block.x, block.P);
      }
      learn_R(noise);
    }
  }

  void run_again() {
    filter_ = prior();
    for (ScoreBlock<n>& block : blocks_.closed()) {
      const ScoreBlock<n> half = block.half();  // its data speak of its middle
      predict(filter_, half);
      update(filter_, block, R_);
      block.x = filter_.x;
      block.P = filter_.P / R_;
      predict(filter_, half);
    }
  }

  // By which power of R each P_ii goes: 1 where nothing changes, 1/2 where Q balances R.
  Vector powers_of_R() const {
    constexpr double more = 1.2;
    LinearKalman<n> as_is = prior(), noisier = prior();
    for (const ScoreBlock<n>& block : blocks_.closed()) {
      predict(as_is, block);
      predict(noisier, block);
      update(as_is, block, R_);
      update(noisier, block, more * R_);
    }
    const Vector ratio = noisier.P.diagonal().cwiseQuotient(as_is.P.diagonal());
    return ratio.array().log().cwiseMax(0.01) / std::log(more);
  }

  // v of each parameter. The rested spring and its loss have one regressor between them: for both
  // it is that of the stiffness now.
  Matrix directions() const {
    const Matrix& P = filter_.P;
    Matrix v = P * P.diagonal().cwiseInverse().asDiagonal();
    if (loss_ >= 0) {
      const Vector now = P.col(k_) - P.col(loss_);
      v.col(k_) = v.col(loss_) = now / (now[k_] - now[loss_]);
    }
    return v;
  }

  // Where the spring wanders less than Q has it, the blocks say that there is no noise at all, and
  // the filter would follow every sample: R is never below the variance from sample to sample.
  // After a long rest there may be nothing to learn from: then what was known stays.
  void learn_R(const LongRunVariances<n>& noise) {
    double sum = 0, dof = 0;
    for (const LongRunVariance& one : noise) {
      if (!one.is_known()) return;
      sum += one.dof() * one.value();
      dof += one.dof();
    }
    noise_ = noise;
    R_ = std::max(sum / dof, white_);
  }

  StateOptions options_;
  int k_, loss_;
  ScaledStates<n> scale_;
  LinearKalman<n> filter_;
  ScoreBlocks<n> blocks_;
  LongRunVariances<n> noise_;
  double R_ = 0;
  double white_ = 0;  // mean of w e^2 over the last seconds
  bool started_ = false;
};

}  // namespace searig::estimator
