// The paper's online estimator for a microcontroller: one stiffness, in float, with nothing but
// additions, multiplications and one division per sample. C++11, no heap, no library.
//
// The host's tests and the ATmega328P compile this same file.
#pragma once

#include <stdint.h>

namespace searig {
namespace estimator {

/// The paper's numbers at the module's own size: PaperUnits::scaled_to of size.h, worked out once
/// on the host. N*m, rad, s.
struct FirmwareSettings {
  float initial_k;         ///< N*m/rad
  float initial_variance;  ///< P at the start, (N*m/rad)^2
  float largest_variance;  ///< P at most
  float gamma;             ///< (3), rad^2/s
  float alpha;             ///< (10), N*m/rad per step
  float beta;              ///< (11), (N*m)^4
  float sample_s;          ///< between two samples, even
};

/// Takes deflection and drive torque at the telemetry's own rate. The estimate is half a window
/// behind, as the rate is.
///
/// Departures from OnlineStiffness:
/// - The rate is that of the straight line through `window` samples, for which running sums do; the
///   host's local cubic would cost more than the filter. The sums are whole numbers, so that
///   nothing piles up: a deflection counts in steps of 2^-20 rad (1 microradian), up to +-4 rad.
/// - (5)-(11) are computed from the moments of the squared error in closed form, which for one
/// state
///   are those of the spherical simplex with w0 = 2/3 (exact_moments.h): no square root.
template <int window = 33>
class FirmwareStiffness {
 public:
  explicit FirmwareStiffness(const FirmwareSettings& settings)
      : settings_(settings), k_(settings.initial_k), P_(settings.initial_variance) {
    const float n = window;
    // slope = 12 sum(j x_j) / (n (n^2 - 1)) per sample, j from -(n-1)/2 to (n-1)/2
    rate_per_sum_ = 12.0f / (n * (n * n - 1.0f) * settings.sample_s) * radian_per_step;
  }

  /// deflection in rad, drive torque (2) in N*m.
  void push(float deflection, float drive) {
    const int32_t newest = static_cast<int32_t>(deflection * steps_per_radian);
    const int32_t oldest = steps_[next_];
    // With every sample one place older: sum j x_j loses the sum of those that stay, and ...
    moment_ += half * (newest + oldest) - (sum_ - oldest);
    sum_ += newest - oldest;
    steps_[next_] = newest;
    drive_[next_] = drive;
    next_ = next_ + 1 == window ? 0 : next_ + 1;
    if (seen_ < window && ++seen_ < window) return;
    const int centre = next_ + half < window ? next_ + half : next_ + half - window;
    step(static_cast<float>(steps_[centre]) * radian_per_step, drive_[centre],
         static_cast<float>(moment_) * rate_per_sum_);
  }

  float k_nm_per_rad() const { return k_; }
  float variance() const { return P_; }
  float weight() const { return w_; }

 private:
  static constexpr int half = (window - 1) / 2;
  static constexpr float steps_per_radian = 1048576.0f;
  static constexpr float radian_per_step = 1.0f / steps_per_radian;
  static_assert(window % 2 == 1 && window >= 5, "the window needs a middle");

  void step(float theta, float T, float rate) {
    // (3)  w = min(1, max(0, theta theta' / gamma))
    w_ = theta * rate / settings_.gamma;
    if (!(w_ > 0)) w_ = 0;
    if (w_ > 1) w_ = 1;
    // (7), (10)  k stands still, Q = alpha k; P has an upper bound, as in OnlineStiffness.
    const float before = k_;
    P_ += settings_.alpha * k_;
    if (P_ > settings_.largest_variance) P_ = settings_.largest_variance;
    if (w_ == 0) return;
    // (8), (9), (11)  e = w (T - k theta)^2 is observed to be 0 with noise beta.
    const float r = T - k_ * theta, q = theta * theta * P_;
    const float r2 = r * r;
    const float y = w_ * (r2 + q);
    const float Pyy = w_ * w_ * q * (4 * r2 + 2 * q) + settings_.beta;
    const float Pxy = -2 * w_ * r * P_ * theta;
    const float K = Pxy / Pyy;
    k_ -= K * y;
    P_ -= K * Pxy;
    // One step changes k by no more than a factor of ten: it stays above 0, whatever comes.
    if (!(k_ > 0.1f * before)) k_ = 0.1f * before;
    if (k_ > 10 * before) k_ = 10 * before;
  }

  FirmwareSettings settings_;
  float rate_per_sum_;
  float k_, P_, w_ = 0;
  int32_t steps_[window] = {};
  float drive_[window] = {};
  int32_t sum_ = 0, moment_ = 0;
  int next_ = 0, seen_ = 0;
};

}  // namespace estimator
}  // namespace searig
