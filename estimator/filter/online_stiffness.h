// The paper's online estimator of the spring's stiffness, as a stream at telemetry rate.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "estimator/filter/fixed_lag.h"
#include "estimator/filter/paper_models.h"
#include "estimator/filter/size.h"
#include "estimator/filter/ssukf.h"

namespace searig::estimator {

struct OnlineOptions {
  double initial_k_nm_per_rad = 0;   ///< must be given, above 0; tenfold wrong is good enough
  double initial_relative_sd = 0.2;  ///< sqrt(P) at the start, over the size's torque/deflection
  double largest_relative_sd = 0.2;  ///< sqrt(P) at most, likewise
  PaperUnits paper{paper_gamma_rad2_per_s, paper_alpha, paper_beta};
  std::optional<Size> size = {};  ///< of the module, where known; otherwise learnt from the stream
  double half_width_s = 0.02;     ///< of the window for the rate, and the lag of the estimate
  std::size_t samples_per_step = 1;  ///< n of (9); 1 is (8)
};

/// The paper's setting as it is, without regard to the module's size and with a P that grows as it
/// may. P starts at (10 N*m/rad)^2; the paper does not print its own.
inline OnlineOptions exactly_as_the_paper(double initial_k_nm_per_rad) {
  return {.initial_k_nm_per_rad = initial_k_nm_per_rad,
          .largest_relative_sd = std::numeric_limits<double>::infinity(),
          .size = paper_size};
}

/// What is known of the spring at one telemetry sample.
struct OnlineEstimate {
  double t_s;
  double k_nm_per_rad;
  double variance;        ///< P, (N*m/rad)^2; infinite before the filter starts
  double weight;          ///< (3), 0 .. 1
  double deflection_rad;  ///< theta of this sample
  double drive_nm;        ///< T_current of this sample
  double torque_nm;       ///< k theta: the estimate of the output torque
};

/// Usage: push() every telemetry sample, then call next() until it has no more. An estimate belongs
/// to the sample half_width_s before the newest, and has seen nothing later than the newest.
///
/// Departures from the paper:
/// - gamma, alpha and beta are taken at the module's own size and telemetry rate
///   (PaperUnits::scaled_to), so that springs of 2 and of 3,000 N*m/rad converge alike, at 100 Hz
///   and at 1 kHz. exactly_as_the_paper() does not.
/// - The filter starts once the module has moved enough to know its size; until then k is the
///   initial one and every weight is 0.
/// - One step may change k by no more than a factor of ten, and all of them by no more than a
///   million: k stays positive and finite, whatever the input.
/// - P has an upper bound. The squared error (8) has no slope where k is right, so that good data
///   take next to nothing out of P while Q adds to it; after a while each sample alone would set k.
///   For the same reason P is the filter's own measure and no confidence interval.
/// - The simplex has w0 = 2/3, with which the moments of (8) are exact; the paper prints no w0.
class OnlineStiffness {
 public:
  /// Throws std::invalid_argument with one sentence where an option makes no sense.
  explicit OnlineStiffness(const OnlineOptions& options);

  /// drive_nm is the torque of the drive model at this sample, (2) or what is better. False where
  /// the sample was left out: not finite, or not later than the one before.
  bool push(double t_s, double deflection_rad, double drive_nm) {
    return lag_.push({t_s, deflection_rad, drive_nm});
  }

  std::optional<OnlineEstimate> next();

  double k_nm_per_rad() const;
  double variance() const;

  /// The size in use, once there is one.
  std::optional<Size> size() const { return options_.size ? options_.size : tracker_.size(); }

 private:
  void filter_step(const Size& size);
  void keep_near(double before);

  OnlineOptions options_;
  FixedLag lag_;
  SizeTracker tracker_;
  std::optional<Ssukf<1>> filter_;
  std::vector<WeightedSample> since_last_step_;
};

}  // namespace searig::estimator
