// The diagnosis in sentences that a technician understands.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "estimator/diagnosis/diagnosis.h"

namespace searig::app {

/// The answer in one or two sentences.
std::string headline(const estimator::Diagnosis& diagnosis);

/// What a number was and what it is now: "k 40 -> 42.1 N·m/rad". One for each number that what
/// was measured does not allow.
std::vector<std::string> moved_numbers(const estimator::Diagnosis& diagnosis,
                                       const std::optional<estimator::Model>& given);

/// One line each: the headline, then each finding with its rivals, what remains, what cannot be
/// decided, and the next experiment.
std::vector<std::string> sentences(const estimator::Diagnosis& diagnosis,
                                   const std::optional<estimator::Model>& given);

}  // namespace searig::app
