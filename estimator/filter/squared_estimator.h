// The paper's filter for several states: a squared error is observed to be 0.
#pragma once

#include <algorithm>
#include <cmath>

#include "estimator/filter/exact_moments.h"
#include "estimator/filter/scaled_states.h"
#include "estimator/filter/ssukf.h"

namespace searig::estimator {

/// The spherical simplex, and the closed form, behind one pair of calls.
template <int n>
struct SquaresBySigmaPoints {
  Ssukf<n> filter;
  const Eigen::Vector<double, n>& x() const { return filter.state(); }
  const Eigen::Matrix<double, n, n>& P() const { return filter.covariance(); }
  void step(const ScaledSample<n>& s, const Eigen::Vector<double, n>& kept,
            const Eigen::Matrix<double, n, n>& Q, double R) {
    using Vector = Eigen::Vector<double, n>;
    const auto stands_still = kept == Vector::Ones();
    const bool ok =
        stands_still
            ? filter.predict(Q)  // (7)
            : filter.predict([&](const Vector& x) { return x.cwiseProduct(kept).eval(); }, Q);
    const auto squared = [&](const Vector& x) {  // (8)
      const double e = s.T - s.phi.dot(x);
      return s.weight * e * e;
    };
    if (ok) static_cast<void>(filter.update(squared, 0.0, R));
  }
};

template <int n>
struct SquaresByMoments {
  ExactMomentFilter<n> filter;
  const Eigen::Vector<double, n>& x() const { return filter.x; }
  const Eigen::Matrix<double, n, n>& P() const { return filter.P; }
  void step(const ScaledSample<n>& s, const Eigen::Vector<double, n>& kept,
            const Eigen::Matrix<double, n, n>& Q, double R) {
    filter.x = filter.x.cwiseProduct(kept);
    filter.P = kept.asDiagonal() * filter.P * kept.asDiagonal();
    filter.step(s.phi, s.T, s.weight, Q, R);
  }
};

/// Departures from the paper, beside those of OnlineStiffness:
/// - (10) gives each state the process noise of a stiffness whose term is as large; that of
///   spring.linear stays in proportion to k.
/// - The simplex of two or more states is drawn close together (unbiased_for_squares); with the
///   plain one the estimates are biased by several standard deviations.
template <int n, template <int> class Squares>
class SquaredEstimator final : public StateEstimator {
 public:
  SquaredEstimator(const SpringStates& states, const StateOptions& options)
      : options_(options), k_(states.stiffness()), loss_(states.softening().value_or(-1)) {}

  void step(const StateSample& sample) override {
    const auto s = scale_.take(sample);
    if (!s) return;
    if (!filter_ || is_too_unsure()) start();
    mean_dt_ += (s->dt_s - mean_dt_) / ++steps_;
    const double step = mean_dt_ / paper_size.step_s;
    const double R = options_.paper.beta * std::pow(scale_.torque() / torque_unit(), 4) / step;
    Vector kept = Vector::Ones();
    const Matrix Q = process_noise_of(*s, step, kept);
    filter_->step(*s, kept, Q, R);  // (5)-(11)
  }

  void state(std::span<double> x) const override {
    for (int i = 0; i < n; ++i) x[i] = filter_ ? filter_->x()[i] * scale_.unit()[i] : 0;
    if (!filter_) x[k_] = options_.initial_k_nm_per_rad;
  }

  std::optional<StateCovariance> covariance() const override { return std::nullopt; }

 private:
  using Vector = Eigen::Vector<double, n>;
  using Matrix = Eigen::Matrix<double, n, n>;

  // The paper's torque in units of this module's: where 2 N*m of its beta are 1 here.
  static constexpr double torque_unit() { return paper_size.torque_nm; }
  static constexpr double relative_sd = 0.2;  // as OnlineOptions has it, at the start and at most

  // P at the start is made for the sizes known then; those of theta^3 and the like may still change
  // a thousandfold. A squared error takes next to nothing out of a P that is too large.
  bool is_too_unsure() const {
    for (int i = 0; i < n; ++i) {
      if (filter_->P()(i, i) > 2 * std::pow(relative_sd * scale_.size(i), 2)) return true;
    }
    return false;
  }

  void start() {
    Vector x = Vector::Zero();
    Matrix P = Matrix::Zero();
    x[k_] = options_.initial_k_nm_per_rad / scale_.unit()[k_];
    if (filter_) x = filter_->x();
    for (int i = 0; i < n; ++i) {
      P(i, i) = std::pow(relative_sd * scale_.size(i), 2);
    }
    filter_.emplace(Squares<n>{{x, P}});
  }

  // (10)  Q = alpha k in the paper's size, where k is 2 N*m over 0.04 rad.
  Matrix process_noise_of(const ScaledSample<n>& s, double step, Vector& kept) const {
    constexpr double paper_k = paper_size.torque_nm / paper_size.deflection_rad;
    Matrix Q = Matrix::Zero();
    for (int i = 0; i < n; ++i) {
      const double size = scale_.size(i);
      const double k = i == k_ ? std::abs(filter_->x()[i]) : size;
      const double room = std::pow(relative_sd * size, 2) - filter_->P()(i, i);
      Q(i, i) =
          std::clamp(options_.paper.alpha / paper_k * size * k * step, 0.0, std::max(0.0, room));
    }
    if (loss_ >= 0 && !s.moves) kept[loss_] = Softening(options_, s.dt_s, 0).kept;
    return Q;
  }

  StateOptions options_;
  int k_, loss_;
  ScaledStates<n> scale_;
  std::optional<Squares<n>> filter_;
  double mean_dt_ = 0;
  double steps_ = 0;
};

}  // namespace searig::estimator
