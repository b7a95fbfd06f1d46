// A recording as a view shows it: read, synchronised, the estimator run over it.
#pragma once

#include <filesystem>
#include <string>

#include "app/rig/history.h"
#include "app/session/session.h"

namespace searig::app::desktop {

struct Recorded {
  Session session;
  History history;
  std::string remark;  ///< what could not be estimated, in sentences; else empty
};

/// Throws with one sentence.
Recorded open_recorded(const std::filesystem::path& recording);

}  // namespace searig::app::desktop
