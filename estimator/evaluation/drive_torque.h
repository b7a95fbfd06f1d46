// What the motor current says the torque was, and how it came to say so.
#pragma once

#include <string>
#include <vector>

#include "estimator/model/model.h"
#include "estimator/signals.h"

namespace searig::estimator {

/// Which of the model's terms make the drive torque.
enum class DriveTerms {
  model,  ///< all of its drive.* terms
  paper,  ///< the paper's equation (2): motor and inertia, no friction
  loop,   ///< all, and the control loop's error stands for the current (see loop_error.h)
};

/// The torque of the drive at every module sample.
struct DriveTorque {
  std::vector<double> nm;    ///< as long as module.t_s, or empty where there is no current
  double offset_nm = 0;      ///< of the load cell, found with a fitted gain; not part of nm
  double gain_nm_per_a = 0;  ///< efficiency * torque constant
  bool fitted = false;       ///< gain found from the load cell: not independent of it
  std::string from;          ///< one sentence: what it was made of
};

/// From the model where it has a motor; else the gain is fitted to the load cell, for the model
/// without one cannot say what an ampere is worth. Where there is a spring, the fit is weighted
/// with the trust weight (3), for current is worth little elsewhere.
DriveTorque drive_torque(const Signals& signals, const Model* model, DriveTerms terms);

}  // namespace searig::estimator
