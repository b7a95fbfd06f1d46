#include "estimator/filter/state_estimator.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "estimator/filter/least_squares_estimator.h"
#include "estimator/filter/linear_estimator.h"
#include "estimator/filter/squared_estimator.h"

namespace searig::estimator {

namespace {

void check(EstimatorKind kind, const SpringStates& states, const StateOptions& options) {
  const auto positive = [](double x) { return std::isfinite(x) && x > 0; };
  if (!positive(options.initial_k_nm_per_rad)) {
    throw std::invalid_argument("the initial stiffness must be a number above 0");
  }
  if (!positive(options.paper.alpha) || !positive(options.paper.beta)) {
    throw std::invalid_argument("alpha and beta must be numbers above 0");
  }
  if (!positive(options.recovery_s) || !positive(options.softening_work) ||
      !positive(options.softening_share) || !(options.drift_per_minute >= 0)) {
    throw std::invalid_argument("the times and shares of drift and recovery must be above 0");
  }
  if (kind == EstimatorKind::rls && states.softening()) {
    throw std::invalid_argument(
        "rls takes the parameters to stand still and has no place for spring.mullins; linear does");
  }
}

template <int n>
std::unique_ptr<StateEstimator> make(EstimatorKind kind, const SpringStates& states,
                                     const StateOptions& options) {
  switch (kind) {
    case EstimatorKind::paper:
      return std::make_unique<SquaredEstimator<n, SquaresBySigmaPoints>>(states, options);
    case EstimatorKind::moments:
      return std::make_unique<SquaredEstimator<n, SquaresByMoments>>(states, options);
    case EstimatorKind::linear:
      return std::make_unique<LinearEstimator<n>>(states, options);
    case EstimatorKind::rls:
      return std::make_unique<LeastSquaresEstimator<n>>(states, options);
  }
  return nullptr;
}

// The number of states is known when the program runs, the filters want it when they are compiled.
template <int n>
std::unique_ptr<StateEstimator> make_for_size(EstimatorKind kind, const SpringStates& states,
                                              const StateOptions& options) {
  if (states.size() == n) return make<n>(kind, states, options);
  if constexpr (n < most_states) return make_for_size<n + 1>(kind, states, options);
  return nullptr;
}

}  // namespace

std::unique_ptr<StateEstimator> make_state_estimator(EstimatorKind kind, const SpringStates& states,
                                                     const StateOptions& options) {
  check(kind, states, options);
  return make_for_size<1>(kind, states, options);
}

}  // namespace searig::estimator
