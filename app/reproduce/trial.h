// One trial of the paper's experiment on the twin: from the hand's pull to the errors of Table I.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "app/reproduce/variant.h"
#include "estimator/signals.h"

namespace searig::app::reproduce {

/// Where the stiffness was, seen from the best fit, once it had been trusted enough.
struct Approach {
  double after_s = 0;               ///< when the trust weight had summed to Protocol::trust_s
  double off_percent = 0;           ///< k less the best fit, over the best fit, at that moment
  double loadcell_off_percent = 0;  ///< the same for the weighted best fit up to then, with the
                                    ///< load cell in place of the current
  double off_later_percent = 0;     ///< mean magnitude of the same from then on
  double within_later_percent = 0;  ///< share of the time from then on within Protocol::within
};

/// What a trial said with one of the variants.
struct OnlineFigures {
  estimator::Score good;             ///< started at the best fit, as for Table I
  estimator::Score poor;             ///< started ten times too high
  double last_k_nm_per_rad = 0;      ///< from there
  std::optional<Approach> approach;  ///< from there; nothing where the trust weight stayed below
};

struct TrialFigures {
  std::uint64_t seed = 0;
  double best_fit_k_nm_per_rad = 0;
  estimator::Score best_fit;
  estimator::Score current;            ///< by equation (2)
  double current_trusted_percent = 0;  ///< error of the current where its weight is above one half
  double current_rest_percent = 0;     ///< and elsewhere; both over mean |measured| of the trial
  std::vector<OnlineFigures> online;   ///< in the order of the variants
  std::vector<double> deflection_rad;  ///< at the load cell's samples
  std::vector<double> measured_nm;
};

/// A trial with all that the figures show; the first variant's estimates.
struct Trial {
  TrialFigures figures;
  estimator::Signals signals;  ///< as recorded, on one clock
  estimator::Evaluation good;  ///< started at the best fit
  estimator::Evaluation poor;  ///< started ten times too high
};

/// The same arguments give the same trial. Throws std::runtime_error with one sentence where there
/// is nothing to estimate.
Trial run_trial(std::uint64_t seed, Hand hand, const Protocol& protocol,
                const std::vector<Variant>& variants);

}  // namespace searig::app::reproduce
