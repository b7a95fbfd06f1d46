// The words and numbers that a diagnosis is told in.
#pragma once

#include <string>
#include <vector>

#include "estimator/diagnosis/diagnosis.h"

namespace searig::app {

/// "98 %" of 0.98.
std::string percent(double share);

/// "a, b and c": `last` stands before the last part, `between` before the others.
std::string joined(const std::vector<std::string>& parts, const std::string& last = " and ",
                   const std::string& between = ", ");

/// The spring's errors, else the drive's; nullptr where the recording has neither.
const estimator::PathErrors* first_of(const estimator::Diagnosis& diagnosis);

/// The path with the larger gain, for the headline; nullptr where the recording has neither.
const estimator::PathErrors* clearest(const estimator::Diagnosis& diagnosis);

/// What the catalogue says of an effect, for people: "dry friction in the gear train".
std::string title_of(const std::string& effect);

/// "almost certain (98 %)".
std::string how_sure(double probability);

/// "deflection between 0.2 and 0.3 rad, or above 0.5 rad"; empty where nothing was located.
std::string where(const estimator::Located& located);

/// "the error on data that no fit has seen falls from 0.21 to 0.011 N·m".
std::string improvement(double before_nm, double after_nm);

/// The same for a finding. Where clocks and zeros can feign it in its own path, it is the other
/// path that shows the gain.
std::string improvement(const estimator::Diagnosis& diagnosis, const estimator::Finding& finding);

/// False for a number that the fit had to leave as the model gave it.
bool is_measured(const estimator::ParameterEstimate& parameter);

/// Those of one effect together, as the catalogue lists them, not by their letters.
std::vector<estimator::ParameterEstimate> in_order(
    std::vector<estimator::ParameterEstimate> parameters);

/// Of a ripple, in words: how many waves each turn of the motor has. Empty where the finding is
/// another one, or the gear ratio is not known (1).
std::string waves_per_turn(const estimator::Finding& finding, double gear_ratio);

}  // namespace searig::app
