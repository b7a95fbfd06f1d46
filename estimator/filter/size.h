// How large a module's torques and deflections are: what makes the paper's numbers dimensionless.
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>

#include "estimator/filter/fixed_lag.h"

namespace searig::estimator {

/// Mean magnitudes while the spring moves, and the time of a filter step.
struct Size {
  double torque_nm;
  double deflection_rad;
  double deflection_rate_rad_s;
  double step_s;
};

/// The size of the paper's module, for which its gamma, alpha and beta hold. The paper prints none
/// of it; these are round numbers for a rubber spring of about 50 N*m/rad, a peak above 6 N*m and
/// telemetry at 500 Hz.
constexpr Size paper_size{
    .torque_nm = 2, .deflection_rad = 0.04, .deflection_rate_rad_s = 0.12, .step_s = 0.002};

/// What the paper's three numbers become for a module of another size. The filter works on k in
/// N*m/rad all the while; this is the same as to run it in the paper's own N*m, rad and s on
/// signals scaled to the paper's size. Of a longer step the same second is to be learnt in fewer
/// steps: more Q and less R in each.
struct PaperUnits {
  double gamma;  ///< (3) in rad^2/s
  double alpha;  ///< (10) Q = alpha k, in N*m/rad
  double beta;   ///< (11) R, in (N*m)^4: the fourth power of a torque

  PaperUnits scaled_to(const Size& size) const {
    const double torque = size.torque_nm / paper_size.torque_nm;
    const double deflection = size.deflection_rad / paper_size.deflection_rad;
    const double rate = size.deflection_rate_rad_s / paper_size.deflection_rate_rad_s;
    const double step = size.step_s / paper_size.step_s;
    return {.gamma = gamma * deflection * rate,
            .alpha = alpha * step * torque / deflection,
            .beta = beta * std::pow(torque, 4) / step};
  }
};

/// Learns the size from the stream itself, without looking ahead. Only samples count at which the
/// spring is seen to move: a rest must not shrink the size, nor may noise pass for motion. Mean
/// magnitudes, for one garbled sample would rule a mean square for long.
class SizeTracker {
 public:
  SizeTracker(double half_width_s, std::size_t samples_per_step)
      : half_width_(half_width_s), samples_per_step_(samples_per_step) {}

  /// Whether the spring is seen to move at this sample.
  bool add(const FixedLag::Rated& rated) {
    const double noise = rated.sample.deflection - rated.smooth;
    if (seen_++ == 0) first_t_ = rated.sample.t;
    last_t_ = rated.sample.t;
    noise2_ += noise * noise;
    const double sigma = std::sqrt(noise2_ / static_cast<double>(seen_));
    const bool moves = std::abs(rated.rate) * half_width_ > sigma;
    if (!moves || std::abs(rated.smooth) < deflection_over_noise * sigma) return moves;
    ++moving_;
    torque_ += std::abs(rated.sample.drive);
    deflection_ += std::abs(rated.smooth);
    rate_ += std::abs(rated.rate);
    return moves;
  }

  /// Nothing until enough motion has been seen.
  std::optional<Size> size() const {
    if (moving_ < least_samples || !(torque_ > 0)) return std::nullopt;
    const double n = static_cast<double>(moving_);
    const double sample_s = (last_t_ - first_t_) / static_cast<double>(seen_ - 1);
    return Size{torque_ / n, deflection_ / n, rate_ / n,
                sample_s * static_cast<double>(samples_per_step_)};
  }

 private:
  static constexpr double deflection_over_noise = 10;
  static constexpr std::size_t least_samples = 20;

  double half_width_;
  std::size_t samples_per_step_;
  double first_t_ = 0, last_t_ = 0;
  std::size_t seen_ = 0, moving_ = 0;
  double noise2_ = 0, torque_ = 0, deflection_ = 0, rate_ = 0;
};

}  // namespace searig::estimator
