// The sets of states and the estimators that a user is offered with an interval.
#pragma once

#include <string>
#include <vector>

#include "tests/estimator/coverage/coverage.h"

namespace searig::estimator {

struct Offered {
  EstimatorKind kind;
  Springs springs;

  std::string name() const {
    std::string out = std::string(name_of(kind)) + ":";
    for (const std::string& state : springs.states) out += " " + state;
    return out;
  }
};

inline std::vector<Offered> offered_sets() {
  const std::vector<std::vector<std::string>> sets = {
      {"spring.linear"},
      {"spring.linear", "spring.viscous"},
      {"spring.linear", "spring.viscous", "spring.cubic"},
      {"spring.linear", "spring.temperature"},
      {"spring.linear", "spring.relaxation:0.5"},
      {"spring.linear", "spring.viscous", "spring.cubic", "spring.temperature"}};
  std::vector<Offered> out;
  for (const auto& states : sets) {
    out.push_back({EstimatorKind::rls, {.states = states}});
    out.push_back({EstimatorKind::linear, {.states = states, .drift_per_minute = 0.05}});
  }
  out.push_back({EstimatorKind::linear,
                 {.states = {"spring.linear", "spring.mullins"},
                  .seconds = 180,
                  .softening_share = 0.25,
                  .recovery_s = 60,
                  .rest_from_s = 60,
                  .rest_to_s = 120}});
  return out;
}

}  // namespace searig::estimator
