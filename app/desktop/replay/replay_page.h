// A recording: opened, looked at, moved through.
#pragma once

#include <filesystem>
#include <memory>

#include "app/desktop/page.h"
#include "app/desktop/replay/recorded.h"

namespace searig::app::desktop {

class HistoryView;

class ReplayPage : public Page {
 public:
  explicit ReplayPage(Shell& shell);

  /// False where it could not be opened; the page then says why, without a dialog.
  bool open(const std::filesystem::path& recording);

  QString caption() const override;
  QString message() const override;
  void set_theme(const Theme& theme) override;

 private:
  void make_actions();

  std::unique_ptr<Recorded> recorded_;
  HistoryView* view_;
};

}  // namespace searig::app::desktop
