// What the model leaves out of the opened recording.
#pragma once

#include <filesystem>

#include "app/desktop/page.h"

class QLabel;

namespace searig::app::desktop {

class DiagnosePage : public Page {
 public:
  explicit DiagnosePage(Shell& shell);

  /// The recording that would be diagnosed; it has been opened on Replay.
  void choose(const std::filesystem::path& recording);

  QString message() const override;
  void set_theme(const Theme&) override {}

 private:
  std::filesystem::path recording_;
  QLabel* hint_;
};

}  // namespace searig::app::desktop
