// Several estimators over one recording, with the states that the user names.
#pragma once

#include "estimator/evaluation/evaluation.h"

namespace searig::estimator {

/// One result for each of options.estimators that can do it; notes say of the others why not.
/// drive_nm is the torque of the drive at every sample. All start from the stiffness that the
/// online estimate started from. The paper's filter for spring.linear alone is the online estimate
/// itself.
std::vector<EstimatorResult> compare_estimators(const Signals& signals, const Model* model,
                                                const std::vector<double>& drive_nm,
                                                const EvaluationOptions& options,
                                                const OnlineResult& online,
                                                std::vector<std::string>& notes);

}  // namespace searig::estimator
