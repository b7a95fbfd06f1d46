// What is the same in every trial, and the ways to estimate that are compared on it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimator/evaluation/evaluation.h"
#include "estimator/model/model.h"

namespace searig::app::reproduce {

/// How the hand at the lever moves. The paper says only that it pulls while the module operates.
enum class Hand {
  holds_against,  ///< as paper_module() has it: the module drives into what the hand holds
  drags_along     ///< it goes along with the module and pulls at will, so that it often drives
};

struct Protocol {
  double seconds = 60.0;         ///< of a trial: room for the trust weight to sum to trust_s
  double figure_seconds = 15.0;  ///< paper, figure 5: the time axis
  double poor_start = 10.0;      ///< paper, figures 9 to 11: "off by a factor of 10"
  double trust_s = 5.0;          ///< trust weight after which the stiffness should be right
  double within = 0.05;          ///< of the best fit, to be right
  double bench_load_nm = 3.0;    ///< at which eta is measured: half of the paper's 6 N*m
  double bench_rad_s = 0.3;      ///< a pace of the experiment
};

/// A filter of several states, of those that `searig evaluate --estimator` offers.
struct StateFilter {
  estimator::EstimatorKind kind;
  std::vector<std::string> states;  ///< the stiffness first
};

/// A drive model and the estimator's numbers.
struct Variant {
  std::string key;   ///< for machines
  std::string name;  ///< for a table
  estimator::Model drive;
  estimator::DriveTerms terms;
  bool exactly_as_the_paper;
  std::optional<StateFilter> filter = {};  ///< instead of the paper's, of the stiffness alone

  estimator::EvaluationOptions from(double initial_k_nm_per_rad) const {
    return {.initial_k_nm_per_rad = initial_k_nm_per_rad,
            .drive = terms,
            .exactly_as_the_paper = exactly_as_the_paper};
  }
};

/// The first is the paper: equation (2), and gamma, alpha and beta as printed. The second takes
/// searig's numbers, which suit a module of any size. The third also knows that the train has dry
/// friction. The fourth also gives the spring the damping term that the paper proposes, equation
/// (12), and observes the torque's error itself in place of its square. What each knows of the
/// drive is from the data sheet and the maker's bench; none has seen a trial.
std::vector<Variant> variants(const Protocol& protocol);

}  // namespace searig::app::reproduce
