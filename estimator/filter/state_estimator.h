// Estimators of several spring parameters at once, to choose among and to compare.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include "estimator/filter/paper_models.h"
#include "estimator/filter/size.h"
#include "estimator/filter/spring_states.h"

namespace searig::estimator {

/// What is observed, and by which filter.
///
/// paper    the squared error (8) is observed to be 0, by the spherical simplex filter. Where the
///          parameters are right the square has no slope: new data hardly lower P, and P is no
///          measure of the error. No interval.
/// moments  the same with the moments of the square in closed form: no sigma points, half the cost.
///          No interval, for the same reason.
/// linear   the error T_current - phi'x itself, with noise R/w: Kalman's filter. The stiffness may
///          drift; every estimate has a 95 % interval.
/// rls      the same for parameters that stand still: recursive least squares. With interval.
enum class EstimatorKind { paper, moments, linear, rls };

constexpr std::string_view name_of(EstimatorKind kind) {
  constexpr std::string_view names[] = {"paper", "moments", "linear", "rls"};
  return names[static_cast<int>(kind)];
}

struct StateOptions {
  double initial_k_nm_per_rad = 0;  ///< must be given, above 0; tenfold wrong is good enough
  PaperUnits paper{paper_gamma_rad2_per_s, paper_alpha, paper_beta};
  /// linear: standard deviation by which the stiffness wanders in a minute, relative to itself.
  /// With spring.mullins among the states the rested spring does not wander.
  double drift_per_minute = 0.05;
  /// The loss of spring.mullins wanders by this share of k (paper, figure 3) with so much work, in
  /// units of the module's mean |T| times mean |theta|; 1500 is 120 J for the paper's module.
  double softening_share = 0.25;
  double softening_work = 1500;
  double recovery_s = 600;  ///< in which a rest brings back 63 % of the loss; rubber takes minutes
};

/// One telemetry sample. phi is as long as there are states.
struct StateSample {
  double dt_s;      ///< since the sample before
  double theta;     ///< rad
  double drive_nm;  ///< T_current
  double weight;    ///< (3), 0 .. 1
  bool moves;       ///< whether the spring is seen to move; else it rests and recovers
  std::span<const double> phi;
};

/// States with their own covariance; what an interval needs.
struct StateCovariance {
  Eigen::MatrixXd covariance;
  Eigen::VectorXd dof;  ///< degrees of freedom behind each variance
};

class StateEstimator {
 public:
  virtual ~StateEstimator() = default;

  /// Allocates nothing. A sample with a number that is not finite changes nothing.
  virtual void step(const StateSample& sample) = 0;

  /// Each in the unit of its amplitude, as long as there are states. Writes to what it is given.
  virtual void state(std::span<double> x) const = 0;

  /// Nothing where the estimator's P says nothing of the error, or as long as too little is known.
  virtual std::optional<StateCovariance> covariance() const = 0;
};

/// Throws std::invalid_argument with one sentence where options make no sense, or the kind has no
/// way for one of the states.
std::unique_ptr<StateEstimator> make_state_estimator(EstimatorKind kind, const SpringStates& states,
                                                     const StateOptions& options);

}  // namespace searig::estimator
