// What the motor current says the torque was, and how it came to say so.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimator/evaluation/survey.h"
#include "estimator/evaluation/telemetry.h"
#include "estimator/model/model.h"

namespace searig::estimator {

/// Which of the model's terms make the drive torque.
enum class DriveTerms {
  model,  ///< all of its drive.* terms
  paper,  ///< the paper's equation (2): motor and inertia, no friction
  loop,   ///< all, and the control loop's error stands for the current (see loop_error.h)
};

/// How the torque of the drive follows from telemetry, sample by sample.
struct DriveRule {
  std::optional<Model> terms;  ///< whose drive terms make it; else the gain alone does
  double gain_nm_per_a = 0;    ///< efficiency * torque constant
  double offset_nm = 0;        ///< of the load cell, found with a fitted gain; not part of nm()
  bool fitted = false;         ///< gain found from the load cell: not independent of it
  std::string from;            ///< one sentence: what it was made of; empty without a current

  /// Whether there is a torque at all.
  bool usable() const;

  /// N*m at the rows [from, to) of the block, which needs a context of differentiator_half_width_s.
  std::vector<double> nm(const TelemetryBlock& block) const;
};

/// From the model where it has a motor; else the gain is fitted to the load cell, for the model
/// without one cannot say what an ampere is worth. Where there is a spring, the fit is weighted
/// with the trust weight (3), for current is worth little elsewhere: the survey must have weights.
DriveRule drive_rule(const Survey& survey, const Model* model, DriveTerms terms);

/// Whether the gain will be fitted.
bool fits_gain(const Model* model);

}  // namespace searig::estimator
