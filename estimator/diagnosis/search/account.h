// The best account of a recording: which terms, named or not, explain what the model left.
#pragma once

#include <deque>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "estimator/diagnosis/search/assess.h"

namespace searig::estimator {

struct Account {
  Scored base;                            ///< the model's own terms, refitted
  Scored final;                           ///< with everything that was found
  std::vector<Assessment> assessments;    ///< one per named piece of `final` that the model lacked
  std::set<std::string> near_names;       ///< that would explain nearly as much as an atom does
  std::deque<Atom> moved_atoms;           ///< that pieces of `final` point to
  std::vector<std::string> switched_off;  ///< in words: terms without their channels
};

/// Called with what is being done and the share of the whole; throws to stop.
using Tell = std::function<void(const std::string& doing, double share)>;

/// Leaves the bench with the noise of the final hypothesis.
Account find_account(Bench& bench, Search& search, const Model& given, const Tell& tell);

}  // namespace searig::estimator
