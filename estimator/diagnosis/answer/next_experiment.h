// Which motion would tell rival models apart best.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/diagnosis/fit/bench.h"
#include "estimator/model/planned_motion.h"

namespace searig::estimator {

/// Motions worth trying, no larger and hardly faster than what the recording shows the rig can do.
std::vector<PlannedMotion> motion_library(const Motion& seen);

/// The library's motions as the rig would record them, were `truth` right and nothing noisy.
class Rehearsal {
 public:
  Rehearsal(const Bench& bench, const Hypothesis& truth, const Model& extended);

  struct Choice {
    PlannedMotion motion;
    double deviance = 0.0;  ///< by which the likeliest rival would fall behind
  };

  /// T-optimal design (A. Atkinson, V. Fedorov, Biometrika 62, 1975): the motion on which the best
  /// of the rivals, its numbers fitted anew, still differs most from the truth, in units of the
  /// recording's noise. Nothing without rivals.
  std::optional<Choice> best_against(const std::vector<Hypothesis>& rivals) const;

 private:
  struct Stage {
    PlannedMotion motion;
    Bench bench;
  };
  static double least_deviance(const Stage& stage, const std::vector<Hypothesis>& rivals,
                               int rounds);

  std::vector<Stage> stages_;
};

}  // namespace searig::estimator
