// The parts of the method that can be left out, to show what each of them is worth.
#pragma once

namespace searig::estimator {

/// Leaving one out is a negative control: the diagnosis must become visibly worse, or the data were
/// too easy to prove anything. docs/proving.md has the figures.
struct Method {
  bool noise_has_memory = true;    ///< else it is taken to be white
  bool looks_for_nameless = true;  ///< else every mismatch gets the nearest name
  bool stiffness_stays = true;     ///< else it follows the recording, as an online estimate does
  static constexpr double adapting_s = 4.0;  ///< time in which a stiffness that follows may change
};

}  // namespace searig::estimator
