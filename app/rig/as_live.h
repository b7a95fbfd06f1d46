// A recording as it was seen live.
#pragma once

#include <filesystem>

#include "app/rig/live_feed.h"

namespace searig::app {

/// Decodes its raw bytes again and follows them as a rig that runs is followed, up to until_s after
/// the first. Throws with one sentence, also where it has no raw bytes (an imported one).
LiveNews as_live(const std::filesystem::path& recording, double until_s);

}  // namespace searig::app
