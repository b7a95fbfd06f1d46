// Numbers as the window says them.
#pragma once

#include <QString>

#include "acquisition/clock/synchronise.h"
#include "acquisition/recording/recording.h"
#include "app/rig/history.h"

namespace searig::app::desktop {

QString stiffness_words(const History& history);
/// The filter's variance as an interval; it is no confidence interval (see online_stiffness.h).
QString spread_words(const History& history);
/// Over the last 20 s while live, else over the whole recording.
QString error_words(const History& history, bool live);
QString weight_words(const History& history);
QString clock_words(const acquisition::Recording& recording, const acquisition::ClockMap& clock);
QString loss_words(const acquisition::Recording& recording);
QString status_words(const acquisition::Recording& recording, const acquisition::ClockMap& clock);

}  // namespace searig::app::desktop
