// The diagnosis as plots: what the simulation misses over time and over a channel.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/report/plot.h"
#include "app/session/examine.h"

namespace searig::app {

/// Which of the two comparisons with the load cell a plot shows.
enum class Against { spring, drive };

/// The path that an effect shows in: the drive's terms in the current, all others in the spring,
/// where the recording has one.
Against path_of(const Examined& examined, const std::string& effect);

/// The comparison that shows the first finding, or what remains.
Against main_path(const Examined& examined);

/// Where the first finding, or what remains, shows most, s on the module's clock; empty where that
/// is nearly everywhere, for then shading tells nothing.
std::vector<std::pair<double, double>> intervals_to_shade(const Examined& examined);

bool has_path(const Examined& examined, Against path);

/// Held-out residual before and after on the same axes; `intervals_s` are shaded.
Plot residual_over_time(const Examined& examined, Against path,
                        const std::vector<std::pair<double, double>>& intervals_s);

/// The same where `before` differs most from `after`, enlarged to about `seconds`.
Plot closer_look(const Examined& examined, Against path, double seconds);

/// Residual before and after over a channel ("deflection_rad"); none where the recording lacks it.
std::optional<Plot> residual_over(const Examined& examined, Against path,
                                  const std::string& channel);

}  // namespace searig::app
