// Whether what a live view shows can be trusted, in words that are read from two metres.
#pragma once

#include <string>

#include "app/rig/live_feed.h"
#include "app/rig/rig_session.h"

namespace searig::app {

enum class Trust { unknown, yes, no };

struct LiveVerdict {
  Trust trust = Trust::unknown;
  std::string words;  ///< "DATA TRUSTED"
  std::string why;    ///< one sentence, and what to do where something is to be done
};

LiveVerdict verdict_of(const LiveNews& news, bool has_model);

/// "12.4 s, 1.3 MB; 72 GB free, enough for 310 h".
std::string recording_words(const RecordingStatus& status);

}  // namespace searig::app
