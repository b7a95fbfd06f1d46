// What one figure of the paper shows, what ours shows, and what agrees: worked out from the trials.
#pragma once

#include <string>
#include <vector>

#include "app/report/axis.h"
#include "app/reproduce/reproduction.h"
#include "app/reproduce/window.h"

namespace searig::app::reproduce {

struct Words {
  std::string paper, ours;
  bool agrees;
  std::string if_so, if_not;  ///< what is said of it either way
  std::string more;           ///< and why, or what to know beside it

  std::string verdict() const {
    return (agrees ? "Agrees: " + if_so : "Differs: " + if_not) + (more.empty() ? "" : " ") + more;
  }
};

inline std::string percent(double value, int decimals = 0) {
  return number(value, decimals) + " %";
}

Words table_words(const Reproduction& all);

/// The trial started at the best fit: figures 4 to 7. Figure 3 needs no trial.
Words mullins_words(const Reproduction& all);
Words current_words(const Reproduction& all, const Window& good);
Words weight_words(const Window& good);
Words online_words(const Window& good);
Words error_words(const Window& good);

/// The trial started ten times too high: figures 9 to 11.
Words poor_torque_words(const Window& poor);
Words poor_error_words(const Window& poor);
Words stiffness_words(const Reproduction& all, const Window& poor);

}  // namespace searig::app::reproduce
