// The module's own units: torques over its mean torque, states over what makes one term as large as
// the whole torque. Filters of several states work in these, whatever the spring's size.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <optional>

#include "estimator/filter/score_blocks.h"
#include "estimator/filter/state_estimator.h"

namespace searig::estimator {

/// A sample in those units: phi, x and T are about 1.
template <int n>
struct ScaledSample {
  Eigen::Vector<double, n> phi;
  double T, weight, dt_s;
  double work;  ///< done on the spring since the sample before, in units of |T| |theta|
  bool moves;

  ScoreBlock<n> sums() const {
    return {weight * phi * phi.transpose(), weight * T * phi, dt_s, moves ? 0 : dt_s, work};
  }
};

/// Learns mean magnitudes while the spring moves, as SizeTracker does; from then on units stand
/// still, and size() is what the means have become since, in those units.
template <int n>
class ScaledStates {
 public:
  using Vector = Eigen::Vector<double, n>;

  /// Nothing until enough motion has been seen, or where a number is not finite.
  std::optional<ScaledSample<n>> take(const StateSample& s) {
    const Eigen::Map<const Vector> phi(s.phi.data());
    const bool sound = phi.allFinite() && std::isfinite(s.drive_nm + s.theta + s.dt_s + s.weight);
    if (!sound) return std::nullopt;
    if (s.moves) {
      ++moving_;
      mean_phi_ += (phi.cwiseAbs() - mean_phi_) / moving_;
      mean_torque_ += (std::abs(s.drive_nm) - mean_torque_) / moving_;
      mean_theta_ += (std::abs(s.theta) - mean_theta_) / moving_;
    }
    const double rise = std::abs(s.theta) - std::abs(last_theta_);
    last_theta_ = s.theta;
    if (!started()) {
      if (moving_ < least_samples || !(mean_torque_ > 0)) return std::nullopt;
      torque_unit_ = mean_torque_;
      for (int i = 0; i < n; ++i) unit_[i] = mean_phi_[i] > 0 ? mean_torque_ / mean_phi_[i] : 1;
    }
    const double work = std::max(0.0, std::abs(s.drive_nm) * rise) / (mean_torque_ * mean_theta_);
    return ScaledSample<n>{phi.cwiseProduct(unit_) / torque_unit_,
                           s.drive_nm / torque_unit_,
                           s.weight,
                           s.dt_s,
                           s.moves ? work : 0,
                           s.moves};
  }

  bool started() const { return torque_unit_ > 0; }
  const Vector& unit() const { return unit_; }  ///< x = unit * scaled x

  /// Mean |T|, and the x_i at which one term is as large as that; both scaled.
  double torque() const { return mean_torque_ / torque_unit_; }
  double size(int i) const { return mean_phi_[i] > 0 ? mean_torque_ / mean_phi_[i] / unit_[i] : 1; }

 private:
  static constexpr int least_samples = 20;

  int moving_ = 0;
  Vector mean_phi_ = Vector::Zero(), unit_ = Vector::Ones();
  double mean_torque_ = 0, mean_theta_ = 0, torque_unit_ = 0, last_theta_ = 0;
};

/// How spring.mullins moves: at rest the loss decays, while work is done it may change.
struct Softening {
  double kept;      ///< factor on the loss
  double variance;  ///< added to it, over k^2

  Softening(const StateOptions& options, double resting_s, double work)
      : kept(std::exp(-resting_s / options.recovery_s)),
        variance(options.softening_share * options.softening_share * work /
                 options.softening_work) {}
};

}  // namespace searig::estimator
