// The paper's models, equation by equation. N*m, rad, s throughout.
#pragma once

#include <algorithm>
#include <numbers>
#include <span>

namespace searig::estimator {

/// The paper writes gamma = 20 and no unit. It holds for degrees and seconds: 20 deg^2/s, which is
/// 0.0061 rad^2/s. Taken for rad^2/s, no weight would ever be above a few thousandths.
constexpr double rad2_from_deg2(double deg2) {
  return deg2 * (std::numbers::pi / 180) * (std::numbers::pi / 180);
}
constexpr double paper_gamma_rad2_per_s = rad2_from_deg2(20);
constexpr double paper_alpha = 1e-4;  ///< (10), with k in N*m/rad, per filter step
constexpr double paper_beta = 1.0;    ///< (11), (N*m)^4: the variance of a squared torque error

/// (3)  w = min(1, max(0, theta theta' / gamma))
/// How far the motor current is to be trusted: not at all while the deflection shrinks (backlash)
/// or rests (stiction), fully while it grows fast.
/// theta in rad, theta' in rad/s, gamma in rad^2/s.
constexpr double trust_weight(double theta, double theta_rate, double gamma) {
  return std::min(1.0, std::max(0.0, theta * theta_rate / gamma));
}

/// (10)  Q = alpha k.  The paper does not say per what time; it is once per filter step.
constexpr double process_noise(double alpha, double k) {
  return alpha * k;
}

/// One sample that the measurement model compares.
struct WeightedSample {
  double theta;         ///< deflection, rad
  double drive_torque;  ///< T_current, N*m
  double weight;        ///< (3)
};

/// (8)  e = w (T_current - T_spring)^2,  T_spring = k theta (1)
constexpr double squared_error(const WeightedSample& sample, double k) {
  const double error = sample.drive_torque - k * sample.theta;
  return sample.weight * error * error;
}

/// (9)  e = sum_i w_i (T_current - T_spring)^2 / n, over the samples since the last filter step.
/// Departure: the paper's sum runs from t-n to t, which is n + 1 samples over n; here it is n
/// samples over n, so that one sample per step gives (8).
constexpr double mean_squared_error(std::span<const WeightedSample> samples, double k) {
  double sum = 0;
  for (const WeightedSample& sample : samples) sum += squared_error(sample, k);
  return sum / static_cast<double>(samples.size());
}

}  // namespace searig::estimator
