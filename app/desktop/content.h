// What the window shows, whatever it comes from: the simulated rig live, or a recording.
#pragma once

#include <QString>
#include <filesystem>
#include <memory>
#include <string>

#include "app/rig/live_rig.h"
#include "app/session/session.h"

namespace searig::app::desktop {

class Content {
 public:
  virtual ~Content() = default;

  virtual QString name() const = 0;
  virtual const acquisition::Recording& recording() const = 0;
  virtual const acquisition::ClockMap& clock() const = 0;
  virtual const History& history() const = 0;
  /// Something the user should know, such as what could not be estimated; else empty.
  virtual QString remark() const { return {}; }

  virtual bool live() const { return false; }
  /// Moves on to this many seconds after the start.
  virtual void run_until(double) {}
};

/// The simulated rig, from now on.
std::unique_ptr<Content> simulated_rig();

/// Reads, synchronises and runs the estimator over it. Throws with one sentence.
std::unique_ptr<Content> open_recording(const std::filesystem::path& folder);

}  // namespace searig::app::desktop
