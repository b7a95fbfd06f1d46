// How often the 95 % intervals hold the truth, over many seeds.
#pragma once

#include <cstdio>
#include <map>

#include "estimator/evaluation/state_track.h"
#include "tests/estimator/coverage/simulated_spring.h"

namespace searig::estimator {

struct Covered {
  int held = 0, of = 0;
  double half_width = 0;  ///< sum, over the truth of k or of the parameter's own spread
  double error = 0, error2 = 0, sd2 = 0;

  double percent() const { return 100.0 * held / of; }
};

/// By parameter name. A seed whose estimator gives no interval counts as not held.
inline std::map<std::string, Covered> coverage(const Springs& springs, EstimatorKind kind,
                                               int seeds, unsigned first_seed = 1) {
  std::map<std::string, Covered> out;
  for (int seed = 0; seed < seeds; ++seed) {
    const SimulatedSpring spring = SpringSimulation(springs, first_seed + unsigned(seed)).run();
    const StateOptions options{.initial_k_nm_per_rad = 2 * springs.k,
                               .drift_per_minute = springs.drift_per_minute,
                               .recovery_s = springs.recovery_s};
    const StateTrack track =
        track_states(spring.module, spring.drive_nm, kind, SpringStates(springs.states), options);
    for (const StateParameter& p : track.parameters) {
      Covered& c = out[p.name];
      const double error = p.value - spring.truth.at(p.name);
      const double half_width = student_95(p.dof) * p.sd;
      c.held += track.has_interval && std::abs(error) <= half_width;
      ++c.of;
      c.half_width += half_width;
      c.error += error;
      c.error2 += error * error;
      c.sd2 += p.sd * p.sd;
    }
  }
  return out;
}

inline void print(const std::string& title, const std::map<std::string, Covered>& covered) {
  std::printf("%s\n", title.c_str());
  for (const auto& [name, c] : covered) {
    std::printf("  %-18s %5.1f %% of %d  +-%.4g  bias %.3g  rms error %.3g  rms sd %.3g\n",
                name.c_str(), c.percent(), c.of, c.half_width / c.of, c.error / c.of,
                std::sqrt(c.error2 / c.of), std::sqrt(c.sd2 / c.of));
  }
}

}  // namespace searig::estimator
