// The online estimate over a whole recording.
#pragma once

#include "estimator/evaluation/evaluation.h"

namespace searig::estimator {

/// Runs the online estimator over the recording. It starts from options.initial_k, else from the
/// model's stiffness, else from the best fit; notes say which. Nothing where no start can be had.
std::optional<OnlineResult> follow_online(const Signals& signals, const Model* model,
                                          const DriveTorque& drive,
                                          const EvaluationOptions& options,
                                          const std::optional<BestFit>& best_fit,
                                          std::vector<std::string>& notes);

}  // namespace searig::estimator
