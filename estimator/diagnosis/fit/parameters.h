// From a fit back to the model file: parameters with their intervals.
#pragma once

#include <vector>

#include "estimator/diagnosis/diagnosis.h"
#include "estimator/diagnosis/fit/bench.h"
#include "estimator/model/model.h"

namespace searig::estimator {

/// The terms of a hypothesis as a model; `given` supplies what no recording can tell (efficiency).
/// Atoms have no place in a model file and are left out.
Model model_of(const Bench& bench, const Hypothesis& hypothesis, const Fit& layout,
               const Eigen::VectorXd& coefficients, const Model& given);

/// All parameters of all catalogue pieces with 95 % intervals, from the curvature of the joint fit
/// in amplitudes, shapes and nuisances.
std::vector<ParameterEstimate> estimate_parameters(const Bench& bench, const Hypothesis& hypothesis,
                                                   const Fit& fit, const Model& given);

}  // namespace searig::estimator
