// The regimes of the drive train in a plot: the same colours wherever there are residuals.
#pragma once

#include <array>

#include "app/desktop/plot/time_plot.h"
#include "estimator/evaluation/regime.h"

namespace searig::app::desktop {

/// Adds dots for each regime; they have the places 0 to 4, in the order of the names.
inline void add_regime_dots(TimePlot& plot) {
  constexpr std::array<Hue, estimator::regime_names.size()> hues{Hue::purple, Hue::blue, Hue::green,
                                                                 Hue::vermilion, Hue::orange};
  for (std::size_t i = 0; i < hues.size(); ++i)
    plot.add_dots(QString::fromLatin1(estimator::regime_names[i]), hues[i]);
}

/// The columns belong to the caller, as TimePlot's.
template <typename Residuals>
void set_regime_dots(TimePlot& plot, const Residuals& residuals) {
  for (std::size_t i = 0; i < residuals.size(); ++i)
    plot.set_data(i, &residuals[i].t_s, &residuals[i].nm);
}

}  // namespace searig::app::desktop
