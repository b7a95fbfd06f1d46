// What can be said of a stream before any estimate: rates, and what its absence switches off.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "acquisition/recording/recording.h"

namespace searig::app {

/// How long the device was heard, without the pauses at restarts, s.
double seconds_of(const acquisition::Stream& stream);

/// How often the device sampled, lost rows included, Hz on its own clock.
double rate_hz(const acquisition::Stream& stream);

/// {"name","received","lost","doubled","garbled","out_of_order","restarts","rate_hz"}
nlohmann::json stream_json(const acquisition::Stream& stream);

/// The same in one line for people.
std::string stream_line(const acquisition::Stream& stream);

/// One sentence for each channel that is missing, with what that switches off.
std::vector<std::string> switched_off(const acquisition::Recording& recording);

}  // namespace searig::app
